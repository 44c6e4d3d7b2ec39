//! Transfer functions as one word of a command: `stops:250=#c9a67c,1200=#f3ead2,threshold=200,upper=3000,opacity=0.8`. It says what a TOML file
//! of stops says.

/// What the word begins with.
const BEGINNING: &str = "stops:";
/// Keys beside the stops.
const KEYS: [&str; 3] = ["threshold", "upper", "opacity"];

/// The text of the TOML file that says the same; `None` where the word is no such function.
pub fn as_toml(word: &str) -> Option<Result<String, String>> {
    word.strip_prefix(BEGINNING).map(|rest| {
        let (mut settings, mut stops) = (String::from("name = \"stops\"\n"), String::new());
        for part in rest.split(',') {
            let (key, value) = part.split_once('=').ok_or_else(|| format!("{part:?} is no VALUE=#RRGGBB"))?;
            let number = |text: &str| text.parse::<f32>().ok().filter(|number| number.is_finite()).map(f64::from);
            if KEYS.contains(&key) {
                let value = number(value).ok_or_else(|| format!("{key}: {value:?} is not a number"))?;
                settings += &format!("{key} = {value:?}\n");
            } else {
                let at =
                    number(key).ok_or_else(|| format!("{key:?} is neither a value nor one of {}", KEYS.join(", ")))?;
                let is_plain = value.bytes().all(|byte| byte == b'#' || byte.is_ascii_alphanumeric());
                let color = is_plain.then_some(value).ok_or_else(|| format!("{value:?} is no colour like #d8c7a0"))?;
                stops += &format!("[[stop]]\nvalue = {at:?}\ncolor = \"{color}\"\n");
            }
        }
        Ok(settings + &stops)
    })
}

#[cfg(test)]
mod tests {
    use crate::volume::transfer;
    use voxtrace::glam::Vec3;
    use voxtrace::volume::{Ramp, Transfer};

    #[test]
    fn one_word_says_what_a_file_says() {
        let word = "stops:300=#ff0000,-12.5=#ffffff,threshold=-100,upper=2e3,opacity=0.5";
        let Transfer { ramp: Ramp::Absolute { low, high, stops }, opacity, .. } = transfer(word).unwrap() else {
            panic!()
        };
        assert_eq!((low, high, opacity), (-100.0, 2000.0, 0.5));
        assert_eq!(stops, [(-12.5, Vec3::ONE), (300.0, Vec3::X)]);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("stops.toml");
        let file = "threshold = -100\nupper = 2000\nopacity = 0.5\n[[stop]]\nvalue = -12.5\ncolor = \"#ffffff\"\n[[stop]]\nvalue = 300\ncolor = \"#ff0000\"\n";
        std::fs::write(&path, file).unwrap();
        assert_eq!(transfer(word).unwrap(), transfer(&path.display().to_string()).unwrap());
        // Without a threshold, the first stop is it.
        let Ramp::Absolute { low, .. } = transfer("stops:7=#102030").unwrap().ramp else { panic!() };
        assert_eq!(low, 7.0);
        for wrong in [
            "stops:",
            "stops:a=#ffffff",
            "stops:1",
            "stops:1=white",
            "stops:1=#fff\"",
            "stops:1=#ffffff,upper=x",
            "stops:nan=#ffffff",
        ] {
            let line = transfer(wrong).unwrap_err().line();
            assert!(line.contains("transfer function") && line.lines().count() == 1, "{wrong}: {line}");
        }
    }
}
