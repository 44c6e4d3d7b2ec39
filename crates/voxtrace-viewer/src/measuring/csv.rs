//! Measurements as CSV (RFC 4180): a row each, numbers in the unit of the scene, points as voxels and as coordinates of the source.

use super::Measure;
use crate::scale::Scale;
use voxtrace::glam::DVec3;

/// Columns of numbers, in their order, as [`super::Value::name`] has them.
const VALUES: [&str; 20] = [
    "distance",
    "dx",
    "dy",
    "dz",
    "horizontal",
    "height",
    "angle",
    "length",
    "climb",
    "between ends",
    "area",
    "area from above",
    "perimeter",
    "beside its plane",
    "volume",
    "voxels",
    "exposed area",
    "size x",
    "size y",
    "size z",
];

/// All of it, with a row of names.
pub fn csv<'a>(measures: impl IntoIterator<Item = &'a Measure>, scale: &Scale) -> String {
    let head = ["name", "kind"].iter().chain(&VALUES).chain(&["unit", "points", "coordinates", "reference system"]);
    let mut text = line(head.map(|name| (*name).to_owned()));
    for measure in measures {
        let values = measure.values();
        let value = |name: &&'static str| {
            let found = values.iter().find(|value| value.name == *name);
            found.map_or(String::new(), |value| scale.in_units(value.quantity, value.number).to_string())
        };
        let coordinates: Vec<DVec3> = measure.points.iter().filter_map(|point| scale.coordinates(*point)).collect();
        let unit = if scale.symbol().is_empty() { "voxel" } else { scale.symbol() };
        let crs = scale.georeference.as_ref().map_or("", |of| of.crs_name());
        let first = [measure.name.clone(), measure.kind.name().to_owned()];
        let last = [unit.to_owned(), points(&measure.points), points(&coordinates), crs.to_owned()];
        text += &line(first.into_iter().chain(VALUES.iter().map(value)).chain(last));
    }
    text
}

/// "1 2 3; 4 5 6".
fn points(points: &[DVec3]) -> String {
    let texts: Vec<String> = points.iter().map(|point| format!("{} {} {}", point.x, point.y, point.z)).collect();
    texts.join("; ")
}

fn line(fields: impl Iterator<Item = String>) -> String {
    let quoted = |field: String| match field.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", field.replace('"', "\"\"")),
        false => field,
    };
    fields.map(quoted).collect::<Vec<_>>().join(",") + "\r\n"
}

#[cfg(test)]
mod tests {
    use super::super::Kind;
    use super::*;
    use voxtrace::georeference::Georeference;
    use voxtrace::scene::Unit;

    #[test]
    fn each_measurement_is_a_row_in_units_of_the_scene() {
        let georeference = Some(Georeference::of_grid(DVec3::new(500_000.0, 0.0, 0.0), 0.5, "EPSG:25832"));
        let scale = Scale { voxel_size: 0.5, unit: Unit::Metre, georeference };
        let points = vec![DVec3::ZERO, DVec3::new(6.0, 8.0, 0.0)];
        let name = "door, \"left\"".to_owned();
        let measure = Measure { name, is_hidden: false, kind: Kind::Distance, points, component: None };
        let text = csv([&measure], &scale);
        let rows: Vec<&str> = text.split_terminator("\r\n").collect();
        assert!(rows[0].starts_with("name,kind,distance,dx,") && rows.len() == 2, "{text}");
        assert!(rows[1].starts_with("\"door, \"\"left\"\"\",distance,5,3,4,0,5,,"), "{}", rows[1]);
        assert!(rows[1].ends_with(",m,0 0 0; 6 8 0,500000 0 0; 500003 4 0,EPSG:25832"), "{}", rows[1]);
        let commas = |row: &str| row.replace("door, ", "").matches(',').count();
        assert_eq!(commas(rows[0]), commas(rows[1]));
    }

    #[test]
    fn every_number_that_there_is_has_a_column() {
        let points: Vec<DVec3> = (0..3).map(|i| DVec3::new(f64::from(i), f64::from(i * i), 1.0)).collect();
        let component = super::super::Component {
            voxels: 1,
            volume: 1.0,
            exposed: 6.0,
            corner: DVec3::ZERO,
            edges: [DVec3::X, DVec3::Y, DVec3::Z],
        };
        let names = Kind::ALL
            .into_iter()
            .flat_map(|kind| super::super::values::values(kind, &points))
            .chain(component.values());
        for value in names {
            assert!(VALUES.contains(&value.name), "{}", value.name);
        }
    }
}
