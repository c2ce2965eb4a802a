//! Messages on their way to the simulation tool (§2.1.5, `logger`).

use crate::error::Error;
use crate::model::{Log, LogLevel};
use crate::status::Status;

/// The categories of messages, with the standard names of §2.2.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    /// Worth knowing.
    Event,
    /// The result may be wrong.
    Warning,
    /// The step was not done.
    Discard,
    /// The instance cannot go on.
    Error,
}

/// The category that stands for all others.
const ALL: &str = "logAll";

impl Category {
    /// All categories, in the order of their gravity.
    pub const ALL: [Self; 4] = [Self::Event, Self::Warning, Self::Discard, Self::Error];

    /// Name in the model description.
    pub fn name(self) -> &'static str {
        match self {
            Self::Event => "logEvents",
            Self::Warning => "logStatusWarning",
            Self::Discard => "logStatusDiscard",
            Self::Error => "logStatusError",
        }
    }

    /// What the category holds, for the model description.
    fn description(self) -> &'static str {
        match self {
            Self::Event => "What is worth knowing, such as files read",
            Self::Warning => "Why a result may be wrong",
            Self::Discard => "Why a step was not done",
            Self::Error => "Why the instance cannot go on",
        }
    }

    /// The category of messages that explain a status.
    pub(crate) fn of(status: Status) -> Self {
        match status {
            Status::Ok | Status::Pending => Self::Event,
            Status::Warning => Self::Warning,
            Status::Discard => Self::Discard,
            Status::Error | Status::Fatal => Self::Error,
        }
    }

    /// The status that a message of the category explains.
    pub fn status(self) -> Status {
        match self {
            Self::Event => Status::Ok,
            Self::Warning => Status::Warning,
            Self::Discard => Status::Discard,
            Self::Error => Status::Error,
        }
    }
}

/// Names and descriptions for `LogCategories`.
pub(crate) fn categories() -> impl Iterator<Item = (&'static str, &'static str)> {
    let own = Category::ALL.iter();
    own.map(|category| (category.name(), category.description())).chain([(ALL, "All messages")])
}

/// Takes an instance's messages.
pub type Sink = Box<dyn FnMut(Category, &str) + Send>;

/// Passes on the messages that are wanted.
///
/// A message that explains a status other than `fmi2OK` always passes: §2.1.3 wants the reason
/// to be shown to the user. `loggingOn` and the categories choose among the rest, the events.
pub(crate) struct Logger {
    sink: Sink,
    events: bool,
    warned: bool,
}

impl Logger {
    pub(crate) fn new(sink: Sink) -> Self {
        Self { sink, events: false, warned: false }
    }

    /// Chooses the categories that pass; none means all.
    ///
    /// # Errors
    /// When a name is not that of a category. Nothing is changed then.
    pub(crate) fn choose(&mut self, on: bool, names: &[&str]) -> Result<(), Error> {
        let known = |name: &str| categories().any(|(category, _)| category == name);
        if let Some(name) = names.iter().find(|name| !known(name)) {
            return Err(Error::UnknownCategory((*name).to_owned()));
        }
        let wanted = |name: &&str| *name == Category::Event.name() || *name == ALL;
        self.events = on && (names.is_empty() || names.iter().any(wanted));
        Ok(())
    }

    /// Passes a message on.
    pub(crate) fn message(&mut self, category: Category, text: &str) {
        if self.events || category != Category::Event {
            (self.sink)(category, text);
        }
    }

    /// Passes the messages of a model on.
    pub(crate) fn drain(&mut self, log: &mut Log) {
        for (level, text) in log.drain() {
            let category = match level {
                LogLevel::Event => Category::Event,
                LogLevel::Warning => Category::Warning,
            };
            self.warned |= level == LogLevel::Warning;
            self.message(category, &text);
        }
    }

    /// Whether a model warned since this was asked last.
    pub(crate) fn take_warned(&mut self) -> bool {
        std::mem::take(&mut self.warned)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    fn logger() -> (Logger, mpsc::Receiver<Category>) {
        let (sender, receiver) = mpsc::channel();
        let sink = move |category, _: &str| sender.send(category).expect("the test listens");
        (Logger::new(Box::new(sink)), receiver)
    }

    #[test]
    fn events_pass_only_when_wanted() {
        let (mut logger, messages) = logger();
        logger.message(Category::Event, "not wanted yet");
        logger.choose(true, &[]).expect("no category to be wrong");
        logger.message(Category::Event, "wanted");
        logger.choose(true, &["logStatusError"]).expect("standard");
        logger.message(Category::Event, "not wanted again");
        assert_eq!(messages.try_iter().collect::<Vec<_>>(), [Category::Event]);
    }

    #[test]
    fn the_reason_of_a_status_always_passes() {
        let (mut logger, messages) = logger();
        logger.choose(false, &[]).expect("no category to be wrong");
        logger.message(Category::Error, "a reason");
        assert_eq!(messages.try_iter().collect::<Vec<_>>(), [Category::Error]);
    }

    #[test]
    fn an_unknown_category_is_named() {
        let (mut logger, _messages) = logger();
        let error = logger.choose(true, &["logEverything"]).unwrap_err();
        assert_eq!(error, Error::UnknownCategory("logEverything".to_owned()));
    }
}
