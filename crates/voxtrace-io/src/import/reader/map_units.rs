//! The units in which a reference system measures: by keys of GeoTIFF (OGC 19-008, annexes B and C) or by WKT (OGC 12-063r5
//! and 18-010r11).

use super::epsg_feet;
use super::wkt::{Item, Node};
use voxtrace_scene::scene::LengthUnit;

/// In which units coordinates are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct MapUnits {
    pub horizontal: Horizontal,
    /// That of heights, where it is said.
    pub vertical: LengthUnit,
}

/// The unit of places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Horizontal {
    Length(LengthUnit),
    /// An angle of so many degrees: the first coordinate is the longitude.
    Angle(f64),
}

impl Default for Horizontal {
    fn default() -> Self {
        Self::Length(LengthUnit::UNKNOWN)
    }
}

/// Keys: the kind of system, systems by number, and units.
const MODEL: u16 = 1024;
const GEOGRAPHIC: u16 = 2048;
const ANGLE_UNIT: u16 = 2054;
const PROJECTED: u16 = 3072;
const LENGTH_UNIT: u16 = 3076;
const VERTICAL: u16 = 4096;
const VERTICAL_UNIT: u16 = 4099;
/// Kinds of systems.
const IS_PROJECTED: u16 = 1;
const IS_GEOGRAPHIC: u16 = 2;
/// What a user defines.
const OWN: u16 = 32_767;

/// Lengths by their numbers (EPSG), in metres.
const LENGTHS: [(u16, f64); 10] = [
    (1025, 0.001),
    (1033, 0.01),
    (9001, 1.0),
    (9002, 0.3048),
    (9003, 1200.0 / 3937.0),
    (9005, 0.304_797_265_4),
    (9030, 1852.0),
    (9036, 1000.0),
    (9093, 1609.344),
    (9096, 0.9144),
];
/// Angles by their numbers, in degrees.
const ANGLES: [(u16, f64); 4] = [(9101, 180.0 / std::f64::consts::PI), (9102, 1.0), (9105, 0.9), (9122, 1.0)];
/// Systems of heights in feet, and in those of the United States.
const FEET: [u16; 9] = [5614, 6130, 6131, 6132, 8050, 8051, 8228, 8897, 5754];
const US_FEET: [u16; 6] = [5702, 6358, 6359, 6360, 8052, 8053];

impl MapUnits {
    /// By the keys of GeoTIFF.
    pub fn of_keys(keys: &[u16]) -> Self {
        let keys = keys.as_chunks::<4>().0;
        let key = |wanted: u16| keys.iter().skip(1).find(|key| key[0] == wanted && key[1] == 0).map(|key| key[3]);
        let length = |wanted| {
            let code = key(wanted)?;
            LENGTHS.iter().find(|(own, _)| *own == code).map(|&(_, metres)| LengthUnit::of_metres(metres))
        };
        let projected = key(PROJECTED).filter(|&code| code != 0);
        let is_geographic = match key(MODEL) {
            Some(model) => model == IS_GEOGRAPHIC,
            None => projected.is_none() && key(GEOGRAPHIC).is_some(),
        };
        let horizontal = if is_geographic {
            let code = key(ANGLE_UNIT).unwrap_or(9102);
            Horizontal::Angle(ANGLES.iter().find(|(own, _)| *own == code).map_or(1.0, |&(_, degrees)| degrees))
        } else {
            // A system of EPSG has its unit, whatever the keys leave out.
            let known = projected.filter(|&code| (1024..OWN).contains(&code)).map(epsg_feet::unit_of_projected);
            let is_said = key(MODEL).is_none_or(|model| model == IS_PROJECTED);
            Horizontal::Length(length(LENGTH_UNIT).or(known.filter(|_| is_said)).unwrap_or_default())
        };
        let of_system = key(VERTICAL).and_then(|code| {
            let is = |codes: &[u16], unit| codes.contains(&code).then_some(unit);
            let is_metres = (5600..9000).contains(&code).then_some(LengthUnit::METRE);
            is(&FEET, LengthUnit::FOOT).or(is(&US_FEET, LengthUnit::US_SURVEY_FOOT)).or(is_metres)
        });
        Self { horizontal, vertical: length(VERTICAL_UNIT).or(of_system).unwrap_or_default() }
    }

    /// By WKT of either version; nothing is known of what is no WKT.
    pub fn of_wkt(text: &str) -> Self {
        const PLANES: [&str; 3] = ["PROJCS", "PROJCRS", "PROJECTEDCRS"];
        const GLOBES: [&str; 6] = ["GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "GEOCCS"];
        const OTHERS: [&str; 3] = ["LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"];
        const HEIGHTS: [&str; 4] = ["VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"];
        let Some(root) = Node::parse(text) else { return Self::default() };
        let found = [&PLANES[..], &GLOBES, &OTHERS].iter().find_map(|names| root.find(names));
        let Some(system) = found else { return Self::default() };
        let is_globe = GLOBES.contains(&&*system.keyword) && system.keyword != "GEOCCS";
        let horizontal = match unit_of(system, 0) {
            Some((name, factor)) if name == "ANGLEUNIT" || name == "UNIT" && is_globe && factor < 0.5 => {
                Horizontal::Angle(factor.to_degrees())
            }
            Some((_, factor)) => Horizontal::Length(LengthUnit::of_metres(factor)),
            None => Horizontal::default(),
        };
        // Heights have a system of their own, or the third axis.
        let vertical = match root.find(&HEIGHTS) {
            Some(heights) => unit_of(heights, 0),
            None => unit_of(system, 2).filter(|(name, _)| *name == "LENGTHUNIT"),
        };
        let vertical = vertical.map(|(_, factor)| LengthUnit::of_metres(factor)).unwrap_or_default();
        Self { horizontal, vertical }
    }
}

/// The unit of a system's axis, by its keyword and factor: that of the axis, or else of the whole system.
fn unit_of(system: &Node, axis: usize) -> Option<(&str, f64)> {
    let unit = |node: &Node| {
        let is_unit = |child: &&Node| matches!(&*child.keyword, "UNIT" | "LENGTHUNIT" | "ANGLEUNIT");
        let unit = node.children().filter(is_unit).last()?;
        let factor =
            unit.items.iter().find_map(|item| if let Item::Number(number) = item { Some(*number) } else { None });
        let keyword = ["UNIT", "LENGTHUNIT", "ANGLEUNIT"].into_iter().find(|known| *known == unit.keyword)?;
        Some((keyword, factor?))
    };
    let axes: Vec<&Node> = system.children().filter(|child| child.keyword == "AXIS").collect();
    match axes.get(axis) {
        Some(axis) => unit(axis).or_else(|| unit(system)),
        None if axis == 0 => unit(system),
        None => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(keys: &[[u16; 2]]) -> MapUnits {
        let all: Vec<u16> = keys.iter().flat_map(|&[key, value]| [key, 0, 1, value]).collect();
        MapUnits::of_keys(&[&[1, 1, 0, keys.len() as u16][..], &all].concat())
    }

    fn plane(unit: LengthUnit, vertical: LengthUnit) -> MapUnits {
        MapUnits { horizontal: Horizontal::Length(unit), vertical }
    }

    #[test]
    fn keys_tell_the_unit_of_plane_and_heights() {
        let (none, metre) = (LengthUnit::UNKNOWN, LengthUnit::METRE);
        let (foot, us_foot) = (LengthUnit::FOOT, LengthUnit::US_SURVEY_FOOT);
        assert_eq!(keys(&[[1024, 1], [3072, 32_767], [3076, 9002]]), plane(foot, none));
        assert_eq!(keys(&[[1024, 1], [3072, 2227], [3076, 9003], [4099, 9001]]), plane(us_foot, metre));
        // The number of a system says its unit, and what the key says goes before it.
        assert_eq!(keys(&[[3072, 2227]]), plane(us_foot, none));
        assert_eq!(keys(&[[3072, 2222], [4096, 6360]]), plane(foot, us_foot));
        assert_eq!(keys(&[[3072, 32_632], [4096, 8228]]), plane(metre, foot));
        assert_eq!(keys(&[[3072, 32_632], [3076, 9002], [4096, 5773]]), plane(foot, metre));
        assert_eq!(keys(&[]), MapUnits::default());
        assert_eq!(keys(&[[3072, 32_767]]), MapUnits::default());
    }

    #[test]
    fn degrees_are_told_from_a_plane_that_names_its_globe() {
        assert_eq!(keys(&[[2048, 4326]]).horizontal, Horizontal::Angle(1.0));
        assert_eq!(keys(&[[1024, 2], [2048, 4326], [2054, 9105]]).horizontal, Horizontal::Angle(0.9));
        assert_eq!(
            keys(&[[1024, 1], [2048, 4269], [3072, 32_767], [3076, 9003]]).horizontal,
            plane(LengthUnit::US_SURVEY_FOOT, LengthUnit::UNKNOWN).horizontal
        );
    }

    #[test]
    fn wkt_of_both_versions_tells_units() {
        let old = r#"COMPD_CS["a + b",PROJCS["NAD83 / California zone 3 (ftUS)",GEOGCS["NAD83",DATUM["x",SPHEROID["GRS 1980",6378137,298.25]],
            PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Lambert_Conformal_Conic_2SP"],PARAMETER["false_easting",6561666.667],
            UNIT["US survey foot",0.304800609601219,AUTHORITY["EPSG","9003"]],AXIS["X",EAST]],VERT_CS["NAVD88",VERT_DATUM["y",2005],UNIT["metre",1.0]]]"#;
        assert_eq!(MapUnits::of_wkt(old), plane(LengthUnit::US_SURVEY_FOOT, LengthUnit::METRE));
        let new = r#"PROJCRS["p",BASEGEOGCRS["g",DATUM["d",ELLIPSOID["e",6378137,298.2,LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]]],
            CONVERSION["c",METHOD["m"],PARAMETER["f",1,LENGTHUNIT["metre",1]]],CS[Cartesian,2],AXIS["east (X)",east,ORDER[1],LENGTHUNIT["foot",0.3048]],
            AXIS["north (Y)",north,ORDER[2],LENGTHUNIT["foot",0.3048]]]"#;
        assert_eq!(MapUnits::of_wkt(new), plane(LengthUnit::FOOT, LengthUnit::UNKNOWN));
        let globe = r#"GEOGCRS["WGS 84",DATUM["d",ELLIPSOID["e",6378137,298.2,LENGTHUNIT["metre",1]]],CS[ellipsoidal,3],AXIS["lat",north,ANGLEUNIT["degree",0.0174532925199433]],
            AXIS["lon",east,ANGLEUNIT["degree",0.0174532925199433]],AXIS["h",up,LENGTHUNIT["foot",0.3048]]]"#;
        let found = MapUnits::of_wkt(globe);
        assert!(matches!(found.horizontal, Horizontal::Angle(degrees) if (degrees - 1.0).abs() < 1e-9), "{found:?}");
        assert_eq!(found.vertical, LengthUnit::FOOT);
        let old = r#"GEOGCS["WGS 84",DATUM["d"],UNIT["degree",0.0174532925199433]]"#;
        assert!(matches!(MapUnits::of_wkt(old).horizontal, Horizontal::Angle(_)));
        assert_eq!(MapUnits::of_wkt(r#"GEOCCS["x",UNIT["metre",1]]"#), plane(LengthUnit::METRE, LengthUnit::UNKNOWN));
        for wrong in
            ["", "hello", "PROJCS[", "PROJCS[\"a\"]", "UNIT[\"foot\",0.3048]", "PROJCS[\"a\",UNIT[\"foot\",x]]"]
        {
            assert_eq!(MapUnits::of_wkt(wrong), MapUnits::default(), "{wrong}");
        }
    }
}
