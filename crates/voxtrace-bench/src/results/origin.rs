//! Where results come from: when they were measured, by which command, with a program of which commit.

use crate::plan::Request;
use serde_json::{Value, json};
use std::time::{SystemTime, UNIX_EPOCH};

/// One run of a benchmark; one that is gone on with has several.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Date and time when it began, UTC, as RFC 3339 has them.
    pub date: String,
    pub command: Option<String>,
    pub commit: Option<String>,
}

impl Origin {
    /// Of what is asked for now.
    pub fn now(request: &Request) -> Self {
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        Self { date: rfc_3339(since.as_secs()), command: request.command.clone(), commit: request.commit.clone() }
    }

    /// For people.
    pub fn text(&self) -> String {
        let of = |name: &str, value: &Option<String>| {
            value.as_ref().map_or(String::new(), |value| format!(", {name} {value}"))
        };
        format!("{}{}{}", self.date, of("commit", &self.commit), of("command", &self.command))
    }

    pub fn json(&self) -> Value {
        json!({ "date": self.date, "command": self.command, "commit": self.commit })
    }

    /// Reads what [`Self::json`] wrote.
    pub fn from_json(json: &Value) -> Self {
        let text = |name: &str| json[name].as_str().map(str::to_owned);
        Self { date: text("date").unwrap_or_default(), command: text("command"), commit: text("commit") }
    }
}

/// Seconds since 1970 as date and time, after H. Hinnant, "chrono-Compatible Low-Level Date Algorithms" (`civil_from_days`): years that begin in
/// March have their leap day at the end.
fn rfc_3339(seconds: u64) -> String {
    let (days, second) = (seconds / 86_400 + 719_468, seconds % 86_400);
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + era * 400 + u64::from(month <= 2);
    let (hour, minute, second) = (second / 3600, second / 60 % 60, second % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_become_dates() {
        // By `date -u -d @SECONDS`.
        let known = [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (951_868_800, "2000-03-01T00:00:00Z"),
            (1_735_689_599, "2024-12-31T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ];
        for (seconds, date) in known {
            assert_eq!(rfc_3339(seconds), date);
        }
    }

    #[test]
    fn an_origin_is_read_as_it_was_written() {
        let origin = Origin { date: rfc_3339(7), command: Some("voxtrace bench".into()), commit: None };
        assert_eq!(Origin::from_json(&origin.json()), origin);
        assert_eq!(origin.text(), "1970-01-01T00:00:07Z, command voxtrace bench");
    }
}
