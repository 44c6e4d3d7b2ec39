//! Volumes on the command line: transfer functions by name or from TOML, and remarks about them.

use crate::failure::{Failure, Kind, reason};
use crate::hounsfield;
use crate::mesh::{MeshArgs, bytes, number};
use crate::overlays::OverlayArgs;
use crate::parse;
use crate::read_failure::can_be_lifted;
use crate::report::Report;
use crate::transfer_text;
use std::path::Path;
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::import::{ImportOptions, RawShape, Several, opened};
use voxtrace::scene::LengthUnit;
use voxtrace::volume::large::Survey;
use voxtrace::volume::{self, LabelColor, Preset, Ramp, Transfer, ValueStatistics, VolumeError, VolumeOptions};
use voxtrace::{Scene, Volume};

/// Voxelization of grids with fewer cells than this is not announced.
const ANNOUNCED_FROM: u64 = 1 << 24;

/// Options about volumes.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Volumes")]
pub struct VolumeArgs {
    /// Transfer function: ct-bone, ct-skin, mri, labels, surface, fog, hot, a TOML file, or stops:VALUE=#RRGGBB,… [default: chosen by the
    /// values]
    #[arg(long, value_name = "NAME|FILE")]
    pub transfer: Option<String>,
    /// Lowest visible value [default: the transfer function's]
    #[arg(long, value_name = "VALUE", value_parser = parse::finite, allow_hyphen_values = true)]
    pub threshold: Option<f32>,
    /// How many voxels lie along the longest side at most, in the place of all: what the window shows while the transfer function is changed.
    #[arg(skip)]
    pub coarse: Option<u32>,
    /// Keep only those voxels of volumes, heightmaps and Minecraft's blocks that have an empty neighbour, as the others are never visible
    /// [default: true; false where the scene is cut]
    #[arg(long, value_name = "BOOL")]
    pub shell: Option<bool>,
    /// Whether what is inside is kept where no option says so: cuts show it.
    #[arg(skip)]
    pub keeps_inside: bool,
    /// Number of the DICOM series to read, where a folder has several, or of the array of an .npz file, from 1 on [default: the series with
    /// the most slices, the largest array]
    #[arg(long, value_name = "NUMBER")]
    series: Option<i64>,
    /// Number of the channel to show, from 1 on [default: all, in their colours]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    channel: Option<u32>,
    /// Number of the time point to read, from 1 on [default: the first]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    time: Option<u32>,
    /// Distance between samples along x, y and z (columns, rows, slices), in --unit or mm [default: the file's]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::spacing)]
    spacing: Option<DVec3>,
    /// Size and sample type of a file without a header: 512x512x300:u16le, or 512x512x300:u16le:1024 to skip 1024 bytes
    #[arg(long, value_name = "SHAPE")]
    raw_shape: Option<RawShape>,
    #[command(flatten)]
    pub overlays: OverlayArgs,
}

impl VolumeArgs {
    /// How files are read.
    pub fn import_options(&self, mesh: &MeshArgs) -> ImportOptions {
        let mut options = mesh.import_options();
        (options.series, options.spacing, options.raw) = (self.series, self.spacing, self.raw_shape);
        (options.channel, options.time) = (self.channel, self.time);
        // Helps to choose among the levels of a picture, before its unit is known.
        options.volume.scale = mesh.scale_asked_for(options.unit.unwrap_or(LengthUnit::MILLIMETRE));
        options
    }

    /// Whether only what has an empty neighbour is kept.
    pub fn shell(&self) -> bool {
        self.shell.unwrap_or(!self.keeps_inside)
    }

    /// The option about what has an empty neighbour, where it is given.
    pub fn shell_asked(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.shell.map(|_| "--shell").into_iter()
    }

    /// Whether an option gives a transfer function, whose colours then go before those of the volume.
    pub fn has_transfer(&self) -> bool {
        self.transfer.is_some()
    }

    /// The transfer function, if an option gives one.
    pub fn transfer(&self) -> Result<Option<Transfer>, Failure> {
        self.transfer.as_deref().map(transfer).transpose()
    }

    /// Voxelizes the volume of a file and reports with which transfer function.
    pub fn scene(
        &self,
        volume: &Volume,
        values: &ValueStatistics,
        path: &Path,
        mesh: &MeshArgs,
        report: &mut Report,
    ) -> Result<Scene, Failure> {
        let options = self.import_options(mesh);
        let transfer =
            self.transfer()?.map_or_else(|| self.overlays.transfer_of(volume, report), |own| Ok(Some(own)))?;
        let is_chosen = transfer.is_some() || self.threshold.is_some();
        let transfer = transfer.unwrap_or_else(|| Transfer::automatic(values));
        let mut settled = transfer.clone();
        settled.resolve(values, self.threshold);
        self.announce(volume, Some(values), &settled, report);
        self.warn_of(values, &settled, path, report, || {
            let Ramp::Absolute { low, .. } = settled.ramp else { return None };
            let shown = volume.values.iter().filter(|value| **value >= low).count();
            Some(shown as f64 / volume.values.len().max(1) as f64)
        });
        let unit = LengthUnit::from(volume.unit).suffix();
        let scale = mesh.scale_asked_for_volume(options.unit.unwrap_or(volume.unit.into()));
        let overlays = self.overlays.over(volume, &options, report)?;
        let options_of_volume =
            VolumeOptions { scale, transfer: Some(transfer), threshold: self.threshold, shell: self.shell(), overlays };
        let failure = |error| volume_failure(path, error);
        if self.coarse.is_none() {
            let estimate = volume::estimate(volume, values, &options_of_volume, &options.limits).map_err(failure)?;
            let [x, y, z] = estimate.size;
            if x * y * z >= ANNOUNCED_FROM {
                let (size, voxels) = (estimate.voxel_size as f32, number(estimate.voxels));
                report.remark(&format!(
                    "on {x} x {y} x {z} voxels of {size}{unit}: about {voxels} voxels, {}",
                    bytes(estimate.bytes)
                ));
            }
        }
        let voxelize = |how: &VolumeOptions| match self.coarse {
            Some(edge) => volume::voxelize_coarse(volume, values, how, edge, &options.limits),
            None => volume::voxelize_with_statistics(volume, values, how, &options.limits),
        };
        let scene = voxelize(&options_of_volume);
        if !is_chosen && matches!(scene, Err(VolumeError::Empty { .. })) {
            let threshold =
                volume::threshold_of_voxels(volume, &options_of_volume, &options.limits).map_err(failure)?;
            report.remark(&lowered(threshold));
            let lower = VolumeOptions { threshold: Some(threshold), ..options_of_volume.clone() };
            return voxelize(&lower).map_err(failure);
        }
        scene.map_err(failure)
    }

    /// Says what a volume holds and what of it is shown.
    fn announce(&self, frame: &Volume, values: Option<&ValueStatistics>, settled: &Transfer, report: &mut Report) {
        let ([x, y, z], spacing) = (frame.size, frame.spacing().as_vec3());
        let unit = LengthUnit::from(frame.unit).suffix();
        let range = values.map_or_else(String::new, |values| format!(", from {} to {}", values.lowest, values.highest));
        report.remark(&format!(
            "{x} x {y} x {z} samples, {} x {} x {}{unit} apart{range}: {} shows {}",
            spacing.x,
            spacing.y,
            spacing.z,
            settled.name,
            settled.shown()
        ));
    }

    /// Warns of a transfer function that is made for other values; `share` is that of the samples which it shows.
    fn warn_of(
        &self,
        values: &ValueStatistics,
        settled: &Transfer,
        path: &Path,
        report: &mut Report,
        share: impl FnOnce() -> Option<f64>,
    ) {
        if let Some(warning) = hounsfield::warning(values, settled, share).filter(|_| self.threshold.is_none()) {
            report.warn(&format!("{}: {warning}", path.display()));
        }
    }

    /// How a volume that stays in its file becomes voxels.
    pub fn options_of_large(&self, frame: &Volume, mesh: &MeshArgs) -> Result<VolumeOptions, Failure> {
        let unit = mesh.import_options().unit.unwrap_or(frame.unit.into());
        let (scale, transfer) = (mesh.scale_asked_for_volume(unit), self.transfer()?);
        Ok(VolumeOptions { scale, transfer, threshold: self.threshold, shell: self.shell(), overlays: Vec::new() })
    }

    /// Says what a volume that stays in its file holds, and on what grid it becomes voxels.
    pub fn announce_large(
        &self,
        frame: &Volume,
        survey: &Survey,
        options: &VolumeOptions,
        path: &Path,
        report: &mut Report,
    ) -> Result<(), Failure> {
        self.announce(frame, survey.values(), survey.transfer(), report);
        let ([x, y, z], size) = survey.grid(frame, options).map_err(|error| volume_failure(path, error))?;
        let unit = LengthUnit::from(frame.unit).suffix();
        report.remark(&format!("on {x} x {y} x {z} voxels of {}{unit}, layer by layer", size as f32));
        Ok(())
    }

    /// Options that are given and choose what of volumes becomes voxels.
    pub fn only_for_volumes(&self) -> impl Iterator<Item = &'static str> {
        let asked = [
            ("--transfer", self.transfer.is_some()),
            ("--threshold", self.threshold.is_some()),
            ("--series", self.series.is_some()),
            ("--channel", self.channel.is_some()),
            ("--time", self.time.is_some()),
            ("--spacing", self.spacing.is_some()),
        ];
        asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option))
    }

    /// Options that are given and choose one of several of a kind in a volume, of which its format has none.
    pub fn only_for_several(&self, several: &[Several]) -> impl Iterator<Item = &'static str> + use<> {
        let asked = [
            ("--series", self.series.is_some(), Several::Series),
            ("--channel", self.channel.is_some(), Several::Channels),
            ("--time", self.time.is_some(), Several::TimePoints),
        ];
        let known = asked.map(|(option, is_asked, kind)| (option, is_asked && !several.contains(&kind)));
        known.into_iter().filter_map(|(option, is_needless)| is_needless.then_some(option))
    }

    /// Warns of a transfer function that is made for other values, once these are known.
    pub fn warn_of_large(&self, survey: &Survey, path: &Path, report: &mut Report) {
        let (Some(values), settled) = (survey.values(), survey.transfer()) else { return };
        self.warn_of(values, settled, path, report, || match settled.ramp {
            Ramp::Absolute { low, .. } => survey.share_from(low),
            _ => None,
        });
    }
}

/// What to say where no voxel reaches the threshold of the samples.
pub fn lowered(threshold: f32) -> String {
    format!("no voxel of that size reaches it: what is {threshold} or more is shown")
}

/// The failure of voxelizing the volume of a file.
pub fn volume_failure(path: &Path, error: VolumeError) -> Failure {
    let message = format!("{}: {error}", path.display());
    match error {
        VolumeError::TooLarge { what, .. } if what.starts_with("voxels along an axis") => {
            Failure::usage(message).hint("a smaller --resolution or larger --voxel-size")
        }
        VolumeError::TooLarge { what, .. } if !can_be_lifted(what) => Failure::usage(message),
        VolumeError::TooLarge { .. } => {
            let hint = "a smaller --resolution or larger --voxel-size; --trusted lifts the limits";
            Failure::usage(message).hint(hint)
        }
        VolumeError::Empty { .. } => Failure::input(message).hint("choose another --transfer or --threshold"),
        VolumeError::BadScale(_) => Failure::usage(message),
        VolumeError::Apart { .. } => {
            Failure::input(message).hint("both have to be in one space; register them with one another first")
        }
        VolumeError::NoPlace { .. } => {
            Failure::input(message).hint("resample it to the scan, or save it in a format that says its place")
        }
        VolumeError::EmptyOverlay { .. } => {
            Failure::input(message).hint("choose another --overlay-threshold, --overlay-transfer or --label-colors")
        }
        _ => Failure::new(Kind::Input, message),
    }
}

/// A transfer function by its name, or from a file.
pub fn transfer(name: &str) -> Result<Transfer, Failure> {
    if let Some(preset) = Preset::ALL.into_iter().find(|preset| preset.name() == name) {
        return Ok(preset.transfer());
    }
    if let Some(text) = transfer_text::as_toml(name) {
        return text.and_then(|text| parse_transfer(&text, "stops")).map_err(|reason| {
            Failure::usage(format!("transfer function {name}: {reason}"))
                .hint("stops:VALUE=#RRGGBB,VALUE=#RRGGBB and threshold=, upper=, opacity= behind them")
        });
    }
    let names = Preset::ALL.map(Preset::name).join(", ");
    opened::note(Path::new(name));
    let text = std::fs::read_to_string(name).map_err(|error| {
        Failure::input(format!("cannot read the transfer function {name}: {}", reason(&error)))
            .hint(format!("it is a TOML file or one of {names}"))
    })?;
    let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
    parse_transfer(&text, &stem).map_err(|reason| {
        Failure::input(format!("transfer function {name}: {reason}"))
            .hint("it holds [[stop]] with value and color, and threshold, or [[label]] with value and color")
    })
}

fn parse_transfer(text: &str, stem: &str) -> Result<Transfer, String> {
    let file: toml::Table = text.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
    if let Some(key) =
        file.keys().find(|key| !["name", "threshold", "upper", "opacity", "stop", "label"].contains(&key.as_str()))
    {
        return Err(format!("`{key}` is unknown"));
    }
    let name = file.get("name").and_then(toml::Value::as_str).unwrap_or(stem).to_owned();
    let number = |table: &toml::Table, key: &str| match table.get(key) {
        None => Ok(None),
        Some(value) => {
            let number = value.as_float().or_else(|| value.as_integer().map(|value| value as f64));
            number.filter(|n| n.is_finite()).map(|n| Some(n as f32)).ok_or_else(|| format!("`{key}` is not a number"))
        }
    };
    let share = |table: &toml::Table| match number(table, "opacity")? {
        Some(opacity) if !(0.0..=1.0).contains(&opacity) => Err(format!("the opacity {opacity} is not from 0 to 1")),
        opacity => Ok(opacity.unwrap_or(1.0)),
    };
    let entries = |key: &str| -> Result<Vec<(f32, LabelColor)>, String> {
        let Some(list) = file.get(key) else { return Ok(Vec::new()) };
        let list = list.as_array().ok_or_else(|| format!("`{key}` is not a list of tables: write [[{key}]]"))?;
        let entry = |entry: &toml::Value| {
            let table = entry.as_table().ok_or_else(|| format!("`{key}` is not a list of tables: write [[{key}]]"))?;
            let value = number(table, "value")?.ok_or_else(|| format!("a {key} without `value`"))?;
            let color = table.get("color").and_then(toml::Value::as_str);
            let color = color.ok_or_else(|| format!("a {key} without `color`, which is text like \"#d8c7a0\""))?;
            if key == "stop" && table.contains_key("opacity") {
                return Err("a stop has no `opacity`; write it above all stops, or for a label".into());
            }
            Ok((value, LabelColor { color: parse::color(color)?.min(Vec3::ONE), opacity: share(table)? }))
        };
        list.iter().map(entry).collect()
    };
    let (mut stops, labels) = (entries("stop")?, entries("label")?);
    stops.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ramp = match (stops.first(), labels.is_empty()) {
        (Some(&(first, _)), true) => {
            let low = number(&file, "threshold")?.unwrap_or(first);
            let stops = stops.into_iter().map(|(value, look)| (value, look.color)).collect();
            Ramp::Absolute { low, high: number(&file, "upper")?.unwrap_or(f32::MAX), stops }
        }
        (None, false) => {
            if let Some((value, _)) = labels.iter().find(|(value, _)| value.fract() != 0.0) {
                return Err(format!("the label {value} is not a whole number"));
            }
            Ramp::Labels(labels.into_iter().map(|(value, look)| (value as i32, look)).collect())
        }
        (Some(_), false) => return Err("both stops and labels".into()),
        (None, true) => return Err("neither stops nor labels".into()),
    };
    Ok(Transfer { name, ramp, opacity: share(&file)? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stops_and_labels_are_read_and_nonsense_is_refused() {
        let bone = "threshold = 300\nupper = 2e3\n[[stop]]\nvalue = 900\ncolor = \"#ffffff\"\n[[stop]]\nvalue = 300\ncolor = \"#ff0000\"";
        let Ramp::Absolute { low, high, stops } = parse_transfer(bone, "bone").unwrap().ramp else { panic!() };
        assert_eq!((low, high, stops), (300.0, 2000.0, vec![(300.0, Vec3::X), (900.0, Vec3::ONE)]));
        let labels = "name = \"organs\"\n[[label]]\nvalue = 7\ncolor = \"#00ff00\"";
        let transfer = parse_transfer(labels, "x").unwrap();
        assert_eq!((transfer.name.as_str(), transfer.ramp), ("organs", Ramp::Labels([(7, Vec3::Y.into())].into())));
        let glassy = "opacity = 0.5\n[[label]]\nvalue = 7\ncolor = \"#00ff00\"\nopacity = 0.25";
        let transfer = parse_transfer(glassy, "x").unwrap();
        let look = LabelColor { color: Vec3::Y, opacity: 0.25 };
        assert_eq!((transfer.opacity, transfer.ramp), (0.5, Ramp::Labels([(7, look)].into())));
        for wrong in [
            "",
            "threshold = 5",
            "treshold = 5\n[[stop]]\nvalue = 1\ncolor = \"#ffffff\"",
            "[[stop]]\nvalue = 1",
            "[[stop]]\ncolor = \"#ffffff\"",
            "[[label]]\nvalue = 1.5\ncolor = \"#ffffff\"",
            "[[stop]]\nvalue = nan\ncolor = \"#ffffff\"",
            "[[stop]]\nvalue = 1\ncolor = \"white\"",
            "stop = 5",
            "opacity = 2\n[[stop]]\nvalue = 1\ncolor = \"#ffffff\"",
            "[[label]]\nvalue = 1\ncolor = \"#ffffff\"\nopacity = -1",
            "[[stop]]\nvalue = 1\ncolor = \"#ffffff\"\nopacity = 0.5",
        ] {
            assert!(parse_transfer(wrong, "x").is_err(), "{wrong}");
        }
    }
}
