//! Offsets and sizes of the records that shaders read and write, from slangc's reflection. The committed list lets a test
//! compare them with the host's records without a shader compiler.

use serde_json::Value;
use std::collections::BTreeMap;

/// Offset and size in bytes of each member, by the member's name.
type Members = Vec<(String, u64, u64)>;

/// Records by name: size in bytes, members in order.
#[derive(Default)]
pub struct Layout(BTreeMap<String, (u64, Members)>);

impl Layout {
    /// Adds the records in the buffers and push constants of a pass.
    ///
    /// # Errors
    /// If a record is laid out differently in two places, or the JSON is invalid.
    pub fn add(&mut self, reflection: &str) -> Result<(), String> {
        let json: Value = serde_json::from_str(reflection).map_err(|error| format!("reflection: {error}"))?;
        self.add_records(&json)
    }

    /// Visits every type in the reflection JSON.
    fn add_records(&mut self, json: &Value) -> Result<(), String> {
        match json {
            Value::Array(values) => values.iter().try_for_each(|value| self.add_records(value)),
            Value::Object(members) => {
                if json["kind"] == "struct" {
                    self.add_record(json)?;
                }
                members.values().try_for_each(|value| self.add_records(value))
            }
            _ => Ok(()),
        }
    }

    fn add_record(&mut self, json: &Value) -> Result<(), String> {
        let name = json["name"].as_str().unwrap_or_default().to_string();
        let fields = json["fields"].as_array().map_or(&[][..], Vec::as_slice);
        let is_in_memory = |field: &Value| field["binding"]["kind"] == "uniform";
        if name.is_empty() || fields.is_empty() || !fields.iter().all(is_in_memory) {
            return Ok(());
        }
        let number = |value: &Value| value.as_u64().ok_or_else(|| format!("record {name}: no offset or size"));
        let members = fields
            .iter()
            .map(|field| {
                let member = field["name"].as_str().unwrap_or_default().to_string();
                Ok((member, number(&field["binding"]["offset"])?, number(&field["binding"]["size"])?))
            })
            .collect::<Result<Members, String>>()?;
        let sizes = json["sizes"].as_array().map_or(&[][..], Vec::as_slice);
        let size = sizes.iter().find(|size| size["kind"] == "uniform").map_or(&Value::Null, |size| &size["value"]);
        let record = (number(size)?, members);
        match self.0.insert(name.clone(), record.clone()) {
            Some(other) if other != record => Err(format!("record {name} has two layouts: {other:?} and {record:?}")),
            _ => Ok(()),
        }
    }

    /// For each record a line `NAME SIZE`, then for each member an indented line `NAME OFFSET SIZE`.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for (name, (size, members)) in &self.0 {
            text += &format!("{name} {size}\n");
            for (member, offset, size) in members {
                text += &format!("  {member} {offset} {size}\n");
            }
        }
        text
    }
}
