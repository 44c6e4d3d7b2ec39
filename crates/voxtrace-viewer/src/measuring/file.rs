//! Measurements in a file beside the scene, `SCENE.measurements.toml`: each is a table `[measurements.N]`. Points are voxels of the scene's
//! world, and, where it has coordinates, those too: with another resolution, or another origin, they are found again by these, else by the size of the
//! voxels.

use super::{Component, Kind, Measure};
use crate::kept_file::{self, KeptError};
use crate::scale::Scale;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::{Table, Value};
use voxtrace::glam::DVec3;

/// The table of all of them, and what errors call them.
const KEY: &str = "measurements";
/// First line of a file that we write.
const HEADER: &str = "# Measurements kept by voxtrace; points are voxels of the scene.\n\n";
/// Most points of one that are read.
const MOST_POINTS: usize = 10_000;
/// Voxels that coordinates, which are rounded, may lie beside their points.
const SAME: f64 = 1e-3;

/// The file of one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureFile {
    path: PathBuf,
    scale: Scale,
}

impl MeasureFile {
    /// The file at `path` of a scene of this scale.
    pub fn new(path: PathBuf, scale: Scale) -> Self {
        Self { path, scale }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads what was measured; where no file is, nothing was.
    ///
    /// # Errors
    /// [`KeptError`] where it cannot be read or is damaged.
    pub fn read(&self) -> Result<BTreeMap<u32, Measure>, KeptError> {
        let table = kept_file::read(KEY, &self.path)?;
        self.all_of(&table).map_err(|reason| KeptError::Damaged { what: KEY, path: self.path.clone(), reason })
    }

    /// Keeps a measurement under a number, the next free one where there is none; returns that. What others wrote there meanwhile stays.
    ///
    /// # Errors
    /// [`KeptError`]; the file is as it was then.
    pub fn store(&self, number: Option<u32>, measure: &Measure) -> Result<u32, KeptError> {
        let all = self.read()?;
        let number = number.unwrap_or_else(|| all.keys().next_back().map_or(1, |last| last.saturating_add(1)));
        self.change(|table| {
            let entry = table.entry(number.to_string()).or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(entry) = entry {
                self.write(measure, entry);
            }
        })?;
        Ok(number)
    }

    /// Forgets a measurement. Errors are those of [`Self::store`].
    pub fn remove(&self, number: u32) -> Result<(), KeptError> {
        self.read()?;
        self.change(|table| drop(table.remove(&number.to_string())))
    }

    fn change(&self, change: impl FnOnce(&mut Table)) -> Result<(), KeptError> {
        let mut table = kept_file::read(KEY, &self.path)?;
        if let Value::Table(all) = table.entry(KEY).or_insert_with(|| Value::Table(Table::new())) {
            change(all);
        }
        kept_file::write(KEY, &self.path, HEADER, &table)
    }

    fn all_of(&self, table: &Table) -> Result<BTreeMap<u32, Measure>, String> {
        let Some(all) = table.get(KEY) else { return Ok(BTreeMap::new()) };
        let all = all.as_table().ok_or_else(|| format!("`{KEY}` is no table"))?;
        // Keys that are no numbers are somebody else's.
        let numbered = all.iter().filter_map(|(key, value)| Some((key.parse().ok()?, value)));
        let read = |(number, value): (u32, &Value)| {
            let entry = value.as_table().ok_or_else(|| format!("measurement {number} is no table"))?;
            let measure = self.measure_of(entry).map_err(|reason| format!("measurement {number}: {reason}"))?;
            Ok((number, measure))
        };
        numbered.map(read).collect()
    }

    fn measure_of(&self, entry: &Table) -> Result<Measure, String> {
        let text = |key: &str| entry.get(key).and_then(Value::as_str);
        let kind = text("kind").and_then(Kind::of_name).ok_or("it has no `kind` that there is")?;
        let mut points = points_of(entry, "points")?;
        let (least, most) = kind.points();
        if points.len() < least || most.is_some_and(|most| points.len() > most) {
            return Err(format!("{} has {} points", kind.name(), points.len()));
        }
        let size = entry.get("voxel_size").and_then(number_of).filter(|size| *size > 0.0);
        let scale = size.map_or(1.0, |size| size / self.scale.voxel_size);
        let coordinates = points_of(entry, "coordinates").unwrap_or_default();
        let georeference = self.scale.georeference.as_ref().filter(|_| coordinates.len() == points.len());
        points.iter_mut().for_each(|point| *point *= scale);
        let mut shift = DVec3::ZERO;
        if let Some(own) = georeference {
            let world = own.coordinates_from_world.inverse();
            let placed: Vec<DVec3> = coordinates.iter().map(|point| world.transform_point3(*point)).collect();
            let is_beside = |(placed, point): (&DVec3, &DVec3)| placed.distance(*point) > SAME;
            if scale != 1.0 || placed.iter().zip(&points).any(is_beside) {
                shift = placed.first().zip(points.first()).map_or(DVec3::ZERO, |(placed, point)| *placed - *point);
                points = placed;
            }
        }
        let component = match entry.get("component") {
            None if kind == Kind::Component => return Err("what was counted is missing".into()),
            None => None,
            Some(value) => {
                let component = component_of(value.as_table().ok_or("`component` is no table")?, scale)?;
                Some(Component { corner: component.corner + shift, ..component })
            }
        };
        let is_hidden = entry.get("hidden").and_then(Value::as_bool).unwrap_or(false);
        Ok(Measure { name: text("name").unwrap_or_default().to_owned(), is_hidden, kind, points, component })
    }

    fn write(&self, measure: &Measure, entry: &mut Table) {
        entry.insert("name".into(), measure.name.clone().into());
        entry.insert("kind".into(), measure.kind.name().into());
        entry.insert("hidden".into(), measure.is_hidden.into());
        entry.insert("voxel_size".into(), self.scale.voxel_size.into());
        entry.insert("points".into(), array(measure.points.iter().copied()));
        entry.remove("coordinates");
        if self.scale.georeference.is_some() {
            let coordinates = measure.points.iter().filter_map(|point| self.scale.coordinates(*point));
            entry.insert("coordinates".into(), array(coordinates));
        }
        if let Some(component) = &measure.component {
            let mut table = Table::new();
            table.insert("voxels".into(), (component.voxels as i64).into());
            table.insert("volume".into(), component.volume.into());
            table.insert("exposed".into(), component.exposed.into());
            table.insert("corner".into(), numbers(component.corner));
            table.insert("edges".into(), array(component.edges));
            entry.insert("component".into(), table.into());
        }
    }
}

fn numbers(point: DVec3) -> Value {
    Value::Array(point.to_array().into_iter().map(Value::Float).collect())
}

fn array(points: impl IntoIterator<Item = DVec3>) -> Value {
    Value::Array(points.into_iter().map(numbers).collect())
}

fn number_of(value: &Value) -> Option<f64> {
    let number = value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))?;
    number.is_finite().then_some(number)
}

fn point_of(value: &Value) -> Result<DVec3, String> {
    let numbers: Option<Vec<f64>> = value.as_array().and_then(|array| array.iter().map(number_of).collect());
    match numbers.as_deref() {
        Some(&[x, y, z]) => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("{value} is no point")),
    }
}

fn points_of(entry: &Table, key: &str) -> Result<Vec<DVec3>, String> {
    let array = entry.get(key).and_then(Value::as_array).ok_or_else(|| format!("it has no `{key}`"))?;
    if array.len() > MOST_POINTS {
        return Err(format!("it has more than {MOST_POINTS} points"));
    }
    array.iter().map(point_of).collect()
}

fn component_of(table: &Table, scale: f64) -> Result<Component, String> {
    let number = |key: &str| table.get(key).and_then(number_of).ok_or_else(|| format!("it has no `{key}`"));
    let corner = point_of(table.get("corner").ok_or("it has no `corner`")?)? * scale;
    let edges: [DVec3; 3] = points_of(table, "edges")?.try_into().map_err(|_| "it has not three `edges`")?;
    Ok(Component {
        voxels: number("voxels")?.max(0.0) as u64,
        volume: number("volume")? * scale.powi(3),
        exposed: number("exposed")? * scale.powi(2),
        corner,
        edges: edges.map(|edge| edge * scale),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use voxtrace::georeference::Georeference;
    use voxtrace::scene::Unit;

    fn scale(voxel_size: f64) -> Scale {
        Scale { voxel_size, unit: Unit::Metre, georeference: None }
    }

    fn distance(x: f64) -> Measure {
        let points = vec![DVec3::new(x, 0.1, 1.0 / 3.0), DVec3::new(1.0, 2.0, 3.0)];
        Measure { name: format!("at {x}"), is_hidden: x > 5.0, kind: Kind::Distance, points, component: None }
    }

    fn counted() -> Measure {
        let component = Component {
            voxels: 8,
            volume: 8.0,
            exposed: 24.0,
            corner: DVec3::ONE,
            edges: [DVec3::X, DVec3::Y, DVec3::Z],
        };
        Measure { kind: Kind::Component, points: vec![DVec3::ONE], component: Some(component), ..distance(1.0) }
    }

    #[test]
    fn what_is_kept_is_read_again_to_the_bit_and_numbers_go_on() {
        let folder = tempfile::tempdir().unwrap();
        let file = MeasureFile::new(folder.path().join("a.measurements.toml"), scale(0.5));
        assert!(file.read().unwrap().is_empty() && !file.path().exists(), "reading makes no file");
        assert_eq!((file.store(None, &distance(0.3)).unwrap(), file.store(None, &counted()).unwrap()), (1, 2));
        file.store(Some(1), &distance(9.0)).unwrap();
        let read = file.read().unwrap();
        assert_eq!(read, BTreeMap::from([(1, distance(9.0)), (2, counted())]));
        assert_ne!(read[&1], distance(0.3), "the comparison sees another one");
        file.remove(1).unwrap();
        assert_eq!(file.store(None, &distance(0.0)).unwrap(), 3, "no number is given twice while the next is there");
        assert_eq!(file.read().unwrap().len(), 2);
    }

    #[test]
    fn of_another_resolution_points_are_found_again_by_coordinates_or_by_the_size_of_voxels() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.measurements.toml");
        MeasureFile::new(path.clone(), scale(0.5)).store(None, &counted()).unwrap();
        let finer = MeasureFile::new(path.clone(), scale(0.25)).read().unwrap();
        let component = finer[&1].component.as_ref().unwrap();
        assert_eq!((finer[&1].points[0], component.volume, component.exposed), (DVec3::splat(2.0), 64.0, 96.0));
        let at = |size, origin| Scale {
            georeference: Some(Georeference::of_grid(DVec3::splat(origin), size, "EPSG:25832")),
            ..scale(size)
        };
        MeasureFile::new(path.clone(), at(0.5, 1000.0)).store(Some(1), &distance(2.0)).unwrap();
        let moved = MeasureFile::new(path, at(0.25, 990.0)).read().unwrap();
        assert_eq!(moved[&1].points[1], DVec3::new(42.0, 44.0, 46.0), "10 further on, and half as large");
        let path = folder.path().join("b.measurements.toml");
        MeasureFile::new(path.clone(), at(0.5, 1000.0)).store(None, &counted()).unwrap();
        let moved = MeasureFile::new(path.clone(), at(0.5, 990.0)).read().unwrap();
        let corner = moved[&1].component.as_ref().unwrap().corner;
        assert_eq!([moved[&1].points[0], corner], [DVec3::splat(21.0); 2], "of the same size, elsewhere");
        let same = MeasureFile::new(path, at(0.5, 1000.0)).read().unwrap();
        assert_eq!(same[&1], counted(), "to the bit where nothing moved");
    }

    #[test]
    fn a_damaged_file_is_one_error_and_is_never_written_over_and_other_keys_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.measurements.toml");
        let file = MeasureFile::new(path.clone(), scale(1.0));
        let damages = [
            "[measurements",
            "measurements = 3",
            "[measurements.1]\nkind = \"guess\"\npoints = []",
            "[measurements.1]\nkind = \"distance\"\npoints = [[1, 2, 3]]",
            "[measurements.1]\nkind = \"angle\"\npoints = [[1, 2, 3], [1, 2], [1, 2, 3]]",
            "[measurements.1]\nkind = \"component\"\npoints = [[1, 2, 3]]",
            "[measurements.1]\nkind = \"distance\"\npoints = [[1, 2, inf], [1, 2, 3]]",
        ];
        for damage in damages {
            fs::write(&path, damage).unwrap();
            let error = file.read().unwrap_err().to_string();
            assert!(error.contains("damaged") && !error.contains('\n'), "{error}");
            assert!(file.store(None, &counted()).is_err() && file.remove(1).is_err());
            assert_eq!(fs::read_to_string(&path).unwrap(), damage);
        }
        let text = "mood = 1\n[measurements]\nby = \"me\"\n[measurements.7]\nkind = \"height\"\npoints = [[0, 0, 0], [0, 0, 1]]\nnote = \"door\"";
        fs::write(&path, text).unwrap();
        let kept = file.read().unwrap()[&7].clone();
        file.store(Some(7), &Measure { name: "door".into(), ..kept }).unwrap();
        let table: Table = fs::read_to_string(&path).unwrap().parse().unwrap();
        assert_eq!((table["mood"].as_integer(), table["measurements"]["by"].as_str()), (Some(1), Some("me")));
        assert_eq!(table["measurements"]["7"]["note"].as_str(), Some("door"));
    }
}
