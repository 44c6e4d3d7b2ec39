//! Whether values are Hounsfield units, for which the transfer functions of CTs are made: in others they show a box.

use voxtrace::volume::{Preset, Ramp, Transfer, ValueStatistics};

/// Air is -1000. Scans without anything near it have no air around what they show, or are measured otherwise.
const AIR: f32 = -500.0;
/// More than this share of all samples is neither bone nor a body with air around it.
const MUCH: f64 = 0.25;
/// What scanners and converters add so that no value is below 0.
const ADDED: f32 = 1024.0;

/// What there is to say about a transfer function in Hounsfield units that shows values which are none; `share` says how many of the samples it
/// shows, where that is known.
pub fn warning(values: &ValueStatistics, transfer: &Transfer, share: impl FnOnce() -> Option<f64>) -> Option<String> {
    let is_for_ct = [Preset::CtBone, Preset::CtSkin].iter().any(|preset| preset.name() == transfer.name);
    let Ramp::Absolute { low, .. } = transfer.ramp else { return None };
    if !is_for_ct || values.lowest < AIR {
        return None;
    }
    let share = share().filter(|share| *share >= MUCH)?;
    let (name, lowest, highest) = (&transfer.name, values.lowest, values.highest);
    let advice = if lowest >= 0.0 && highest < 8192.0 {
        format!("if {ADDED} was added to them, --threshold {} shows what is meant; ", low + ADDED)
    } else {
        String::new()
    };
    Some(format!(
        "values from {lowest} to {highest} are hardly Hounsfield units, in which air is -1000: {name} shows {:.0} % of all samples, as a box; {advice}--transfer mri goes by the values alone",
        share * 100.0
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::Volume;

    /// A body in air, of which a tenth is bone; `added` to all.
    fn said(added: f32, preset: Preset, has_air: bool) -> Option<String> {
        let value = |n: usize| match n % 10 {
            0 => 800.0,
            1..6 => 40.0,
            _ if has_air => -1000.0,
            _ => -80.0,
        };
        let volume = Volume::new([10; 3], (0..1000).map(|n| value(n) + added).collect());
        let transfer = preset.transfer();
        warning(&volume.statistics(), &transfer, || {
            let Ramp::Absolute { low, .. } = transfer.ramp else { return None };
            Some(volume.values.iter().filter(|value| **value >= low).count() as f64 / 1000.0)
        })
    }

    #[test]
    fn only_what_is_no_hounsfield_unit_is_told() {
        for preset in [Preset::CtBone, Preset::CtSkin] {
            assert_eq!(said(0.0, preset, true), None);
            assert!(said(1024.0, preset, true).is_some_and(|text| text.contains("values from 24 to 1824")));
        }
        assert!(said(1024.0, Preset::CtSkin, true).unwrap().contains("--threshold 724"));
        assert!(said(1024.0, Preset::CtBone, true).unwrap().contains("--threshold 1274"));
        // Cut out of a body: bones are fine, the skin is a box.
        assert_eq!(said(0.0, Preset::CtBone, false), None);
        assert!(said(0.0, Preset::CtSkin, false).is_some_and(|text| !text.contains("--threshold")));
        assert_eq!(said(1024.0, Preset::Mri, true), None);
    }
}
