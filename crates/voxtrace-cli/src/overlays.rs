//! What is laid over a volume: a label map with its colours, and a second volume.

use crate::failure::{Failure, reason};
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use crate::volume::transfer;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use voxtrace::Volume;
use voxtrace::import::{Data, ImportErrorKind, ImportOptions, READERS, opened, read_label_colors};
use voxtrace::volume::{LabelColor, Overlay, Preset, Ramp, Transfer, VolumeError};

/// Looks of labels.
type Table = BTreeMap<i32, LabelColor>;

/// Options about what lies over a volume.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Volumes")]
pub struct OverlayArgs {
    /// A volume of labels, a whole number for each sample, to show over the scan in the colours of the labels
    #[arg(long, value_name = "FILE")]
    labels: Option<PathBuf>,
    /// Colours and opacities of labels: a table of FreeSurfer, 3D Slicer, ITK-SNAP or BIDS, CSV, or a TOML file [default: distinct colours]
    #[arg(long, value_name = "FILE")]
    label_colors: Option<PathBuf>,
    /// Opacity of the labels, from 0 to 1: how much of what lies behind them they hide; multiplies the opacities of the table
    #[arg(long, value_name = "SHARE", default_value = "1", value_parser = parse::share, requires = "labels")]
    label_opacity: f32,
    /// A second volume to show over the first, for example a PET over a CT
    #[arg(long, value_name = "FILE")]
    overlay: Option<PathBuf>,
    /// Transfer function of the second volume, by name or from a TOML file
    #[arg(long, value_name = "NAME|FILE", default_value = "hot", requires = "overlay")]
    overlay_transfer: String,
    /// Lowest visible value of the second volume [default: its transfer function's]
    #[arg(long, value_name = "VALUE", value_parser = parse::finite, allow_hyphen_values = true, requires = "overlay")]
    overlay_threshold: Option<f32>,
    /// Opacity of the second volume, from 0 to 1: how much of what lies behind it it hides
    #[arg(long, value_name = "SHARE", default_value = "1", value_parser = parse::share, requires = "overlay")]
    overlay_opacity: f32,
}

impl OverlayArgs {
    /// Whether nothing is asked for.
    pub fn is_bare(&self) -> bool {
        self.labels.is_none() && self.label_colors.is_none() && self.overlay.is_none()
    }

    /// Refuses what does not lie over anything: `path` holds no volume.
    pub fn refuse(&self, path: &Path) -> Result<(), Failure> {
        let asked = [("--labels", &self.labels), ("--label-colors", &self.label_colors), ("--overlay", &self.overlay)];
        match asked.into_iter().find(|(_, file)| file.is_some()) {
            Some((option, _)) => {
                Err(Failure::usage(format!("{option} needs a volume, and {} is none", path.display())))
            }
            None => Ok(()),
        }
    }

    /// Tells wrong names and tables before hours of reading; `has_transfer` where the scan has a transfer function by option.
    pub fn check(&self, has_transfer: bool) -> Result<(), Failure> {
        if self.label_colors.is_some() && self.labels.is_none() && has_transfer {
            let failure = Failure::usage("--label-colors and --transfer both say how the scan looks");
            return Err(failure.hint("leave out one of them, or name a label map by --labels"));
        }
        self.table()?;
        if self.overlay.is_some() {
            transfer(&self.overlay_transfer)?;
        }
        Ok(())
    }

    /// The transfer function of the scan itself, where it is the label map.
    pub fn transfer_of(&self, volume: &Volume, report: &Report) -> Result<Option<Transfer>, Failure> {
        if self.labels.is_some() || self.label_colors.is_none() {
            return Ok(None);
        }
        self.transfer_of_labels(volume, report).map(Some)
    }

    /// What lies over the volume, the topmost last.
    pub fn over(&self, scan: &Volume, options: &ImportOptions, report: &Report) -> Result<Vec<Overlay>, Failure> {
        let mut overlays = Vec::new();
        if let Some(path) = &self.overlay {
            let volume = read(path, scan, options, report)?;
            let values = volume.statistics();
            let mut transfer = transfer(&self.overlay_transfer)?;
            transfer.resolve(&values, self.overlay_threshold);
            transfer.opacity *= self.overlay_opacity;
            let (lowest, highest, shown) = (values.lowest, values.highest, transfer.shown());
            report.remark(&format!(
                "over it {}, from {lowest} to {highest}: {} shows {shown}",
                volume.name, transfer.name
            ));
            overlays.push(Overlay { volume: Arc::new(volume), transfer });
        }
        if let Some(path) = &self.labels {
            let volume = read(path, scan, options, report)?;
            let mut transfer = self.transfer_of_labels(&volume, report)?;
            transfer.opacity *= self.label_opacity;
            overlays.push(Overlay { volume: Arc::new(volume), transfer });
        }
        Ok(overlays)
    }

    /// Looks of the labels that a volume has, from the table where there is one.
    fn transfer_of_labels(&self, volume: &Volume, report: &Report) -> Result<Transfer, Failure> {
        let labels = volume.labels().map_err(|error| {
            let failure = Failure::input(&error);
            let is_no_label_map = matches!(error, VolumeError::NoLabels { .. });
            if is_no_label_map {
                failure.hint("labels are whole numbers; 0 is none; --overlay takes other volumes")
            } else {
                failure
            }
        })?;
        let count =
            |count: usize, what: &str| if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") };
        let range = format!("{} of {}", count(labels.len(), "label"), volume.name);
        let Some((name, table)) = self.table()? else {
            report.remark(&format!("{range}, each in a colour of its own"));
            return Ok(Transfer::of_labels(&labels));
        };
        let known: Table = labels.iter().filter_map(|label| Some((*label, *table.get(label)?))).collect();
        if known.is_empty() {
            let few: Vec<String> = labels.iter().take(8).map(i32::to_string).collect();
            let more = if labels.len() > few.len() { ", …" } else { "" };
            let message = format!("{name} has none of the labels of {}: {}{more}", volume.name, few.join(", "));
            return Err(Failure::input(message));
        }
        let left_out = labels.len() - known.len();
        let rest = if left_out > 0 { format!("; {left_out} without a colour are not shown") } else { String::new() };
        report.remark(&format!("{range} in the colours of {name}{rest}"));
        Ok(Transfer::new(Preset::Labels.name(), Ramp::Labels(known)))
    }

    /// The table of colours, with its name for people.
    fn table(&self) -> Result<Option<(String, Table)>, Failure> {
        let Some(path) = &self.label_colors else { return Ok(None) };
        let name = path.display().to_string();
        let is_toml = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"));
        let table = if is_toml {
            let Ramp::Labels(table) = transfer(&name)?.ramp else {
                return Err(Failure::input(format!("{name}: stops, but no labels"))
                    .hint("write [[label]] with value and color"));
            };
            table
        } else {
            read_label_colors(path).map_err(|error| match &error.kind {
                ImportErrorKind::Io(io) => Failure::input(format!("cannot read {name}: {}", reason(io))),
                _ => Failure::input(&error).hint(
                    "a line is value,#rrggbb or value,red,green,blue, or as FreeSurfer, Slicer or ITK-SNAP write it",
                ),
            })?
        };
        Ok(Some((name, table)))
    }
}

/// Reads a volume that is to lie over another one.
fn read(path: &Path, scan: &Volume, options: &ImportOptions, report: &Report) -> Result<Volume, Failure> {
    opened::note(path);
    let unreadable = |error: voxtrace::import::ImportError| match &error.kind {
        ImportErrorKind::Io(io) => Failure::input(format!("cannot read {}: {}", path.display(), reason(io))),
        _ => import_failure(&error),
    };
    // A spacing that is asked for is that of the scan.
    let own = ImportOptions { spacing: None, series: None, channel: None, time: None, ..options.clone() };
    let data = READERS.open(path, &own).and_then(|opened| opened.read()).map_err(unreadable)?;
    for note in data.notes() {
        report.warn(&format!("{}: {note}", path.display()));
    }
    let Data::Volume(mut volume) = data else {
        return Err(Failure::input(format!("{} holds no volume", path.display())));
    };
    if options.spacing.is_some() && volume.size == scan.size {
        (volume.world_from_index, volume.unit) = (scan.world_from_index, scan.unit);
    }
    Ok(volume)
}
