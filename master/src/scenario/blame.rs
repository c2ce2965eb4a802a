//! Which key of a scenario a component complains of.

use files::Mistake;

use super::file::Scenario;
use super::value::quoted;

impl Scenario {
    /// The mistake at the key whose parameter a component names first in its message, if it names one.
    pub fn blamed(&self, component: &str, message: &str) -> Option<Mistake> {
        let message = message.trim().trim_start_matches("the initialization failed: ");
        let keys = self.keys_of(component);
        let is_of_name = |c: char| c.is_alphanumeric() || "._[]".contains(c);
        let mut words = message.split(|c| !is_of_name(c));
        let key = words.find_map(|word| keys.iter().find(|(name, _)| name == word))?;
        Some(self.check().wrong(&key.1, message))
    }

    /// The parameters of a component that the scenario sets, each with its key.
    fn keys_of(&self, component: &str) -> Vec<(String, String)> {
        let mut keys = vec![];
        if let Some(heat) = self.heat.as_ref().filter(|_| component.starts_with("rail")) {
            let of_name =
                |name: &String| (name.clone(), format!("heat.parameters.{}", quoted(name)));
            keys.extend(heat.parameters.keys().map(of_name));
            keys.push(("model".to_owned(), "heat.model".to_owned()));
        }
        for (i, other) in self.fmus.vehicle_at.iter().enumerate() {
            let list = format!("fmus.vehicle_at[{}].parameters", i + 1);
            if component == format!("vehicle[{}]", other.vehicle) {
                let names = other.parameters.keys();
                keys.extend(names.map(|name| (name.clone(), format!("{list}.{}", quoted(name)))));
            }
        }
        keys
    }
}
