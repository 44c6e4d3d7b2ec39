//! Lines for people: what is said, how long it stays, and what takes it away.

use super::Session;
use crate::tr;
use std::time::{Duration, Instant};

/// How long a message stays. What went wrong stays until Esc, or until another scene is there.
const MESSAGE_TIME: Duration = Duration::from_secs(12);
/// Most messages at a time.
const MOST_MESSAGES: usize = 6;
/// A line for people.
#[derive(Clone, Debug)]
pub struct Message {
    /// What it says.
    pub text: String,
    /// Whether something went wrong.
    pub is_error: bool,
    since: Instant,
}

impl Session {
    /// Says something to whoever looks. What is said again is no second line.
    pub fn say(&mut self, text: impl Into<String>, is_error: bool) {
        let text = text.into();
        self.messages.retain(|message| message.text != text);
        self.messages.push_back(Message { text, is_error, since: Instant::now() });
        if self.messages.len() > MOST_MESSAGES {
            // What went wrong stays longer than whatever else was said before.
            let oldest = self.messages.iter().take(MOST_MESSAGES).position(|message| !message.is_error).unwrap_or(0);
            self.messages.remove(oldest);
        }
    }

    /// Says something in place of whatever of `others` is still to be seen.
    pub fn say_instead(&mut self, others: &[&str], text: impl Into<String>) {
        self.messages.retain(|message| !others.contains(&message.text.as_str()));
        self.say(text, false);
    }

    /// The messages that are still to be seen, oldest first.
    pub fn messages(&mut self) -> impl Iterator<Item = &Message> {
        self.messages.retain(|message| message.is_error || message.since.elapsed() < MESSAGE_TIME);
        self.messages.iter()
    }

    /// Takes away what went wrong. Returns whether there was something.
    pub fn dismiss_errors(&mut self) -> bool {
        let before = self.messages.len();
        self.messages.retain(|message| !message.is_error);
        self.messages.len() < before
    }

    /// Whether there are messages.
    pub fn has_messages(&self) -> bool {
        !self.messages.is_empty()
    }

    /// Says how quickly one flies.
    pub fn say_speed(&mut self) {
        let text = tr!("said.speed", speed = format!("{:.0}", self.navigator.speed()));
        // It takes the place of the last one, whose number alone is another.
        let ending = tr!("said.speed", speed = "");
        self.messages.retain(|message| !message.text.ends_with(&ending));
        self.say(text, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_vulkan::Traversal;

    #[test]
    fn what_went_wrong_is_not_pushed_out_by_lines_that_say_less() {
        let mut session = Session::new(Traversal::Cpu);
        session.say("it cannot be kept", true);
        (0..MOST_MESSAGES).for_each(|number| session.say(format!("note {number}"), false));
        let texts: Vec<String> = session.messages().map(|message| message.text.clone()).collect();
        assert_eq!((texts.len(), texts[0].as_str(), texts[1].as_str()), (MOST_MESSAGES, "it cannot be kept", "note 1"));
        (0..MOST_MESSAGES).for_each(|number| session.say(format!("fault {number}"), true));
        session.say("a last note", false);
        let texts: Vec<&str> = session.messages().map(|message| message.text.as_str()).collect();
        assert_eq!((texts.len(), texts[0], texts[MOST_MESSAGES - 1]), (MOST_MESSAGES, "fault 1", "a last note"));
    }
}
