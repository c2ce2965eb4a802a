//! The logger: who is told what.

use fmu::Status;

use crate::tool::{Fmu, Order};

#[test]
fn messages_carry_instance_status_and_category() {
    let fmu = Fmu::initializing();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    let messages = fmu.messages();
    assert_eq!(messages.len(), 1, "{messages:?}");
    let message = &messages[0];
    assert_eq!(message.instance, "a spring");
    assert_eq!((message.status, message.category.as_str()), (0, "logEvents"));
    // A percent sign does no harm.
    assert_eq!(message.text, "100 % ready with 1 kg");
}

#[test]
fn events_are_told_only_when_logging_is_on() {
    let quiet = Order { logging_on: false, ..Order::default() };
    let fmu = Fmu::order(quiet).unwrap_or_else(|messages| panic!("{messages:?}"));
    fmu.begin();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.messages(), []);
    // The reason of an error is told in any case.
    assert_eq!(fmu.do_step(0.0, -1.0), Status::Error);
    assert_eq!(fmu.messages()[0].category, "logStatusError");
}

#[test]
fn categories_choose_what_is_told() {
    for (on, categories, told) in [
        (true, &[][..], 1),
        (true, &[c"logEvents"][..], 1),
        (true, &[c"logStatusError", c"logAll"][..], 1),
        (true, &[c"logStatusError"][..], 0),
        (false, &[][..], 0),
        (false, &[c"logEvents"][..], 0),
    ] {
        let fmu = Fmu::initializing();
        assert_eq!(fmu.set_debug_logging(on, categories), Status::Ok);
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
        assert_eq!(fmu.messages().len(), told, "{on} {categories:?}");
    }
}

#[test]
fn an_unknown_category_is_a_warning_that_names_it() {
    let fmu = Fmu::initializing();
    assert_eq!(fmu.set_debug_logging(true, &[c"logEverything"]), Status::Warning);
    assert!(fmu.message().contains("`logEverything`"));
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
}
