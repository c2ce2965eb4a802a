//! What a document says, as a structure of the program.

use serde::de::DeserializeOwned;

use crate::document::Document;
use crate::key::{self, Found};
use crate::mistake::{Mark, Mistake};
use crate::structure;

impl Document {
    /// What the TOML text says, as the structure `T`.
    ///
    /// # Errors
    /// When it is not TOML, lacks a key, has an unknown one, or a value of another type.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, Mistake> {
        toml::from_str(self.text()).map_err(|error| structure::mistake::<T>(self, &error))
    }

    /// What a table says, put together of this document's keys and those of others, as the structure `T`.
    ///
    /// # Errors
    /// As of [`Document::parse`]; a key that stands in this document is marked in it.
    pub fn parse_table<T: DeserializeOwned>(&self, table: &toml::Table) -> Result<T, Mistake> {
        table.clone().try_into().or_else(|_| {
            // A text of the whole table gives the mistake its key, which is then looked up here.
            let whole = Self::new(self.name(), table.to_string());
            toml::from_str(whole.text()).map_err(|error| {
                let mark = error.span().and_then(|span| {
                    match key::find(self.text(), &key::at(whole.text(), span.start))? {
                        Found::Value(bytes) => Some(Mark::new(self.text(), bytes)),
                        Found::Holder(_) => None,
                    }
                });
                Mistake { mark, ..structure::mistake::<T>(&whole, &error) }
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A vehicle that extends another is such a table.
    #[test]
    fn a_mistake_in_a_table_of_several_documents_is_marked_in_its_own() {
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        #[expect(dead_code, reason = "read by serde only")]
        struct Vehicle {
            mass_kg: f64,
            length_m: f64,
        }
        let own = Document::new("own.toml", "extends = \"base\"\nmass_kg = \"12\"\n");
        let mut table: toml::Table = own.parse().unwrap();
        table.remove("extends");
        let base = toml::toml! { length_m = 20.0 };
        table.extend(base);
        let message = own.parse_table::<Vehicle>(&table).unwrap_err().to_string();
        let wanted = "own.toml:2:11: mass_kg = \"12\": must be a number, without quotes";
        assert!(message.starts_with(wanted), "{message}");
        table.insert("mass_kg".to_owned(), 12.0.into());
        assert_eq!(own.parse_table::<Vehicle>(&table).unwrap().length_m, 20.0);
        // What the other document has wrong has no mark in this one.
        table.insert("length_m".to_owned(), true.into());
        let message = own.parse_table::<Vehicle>(&table).unwrap_err().to_string();
        assert_eq!(message, "own.toml: length_m = true: must be a number");
    }
}
