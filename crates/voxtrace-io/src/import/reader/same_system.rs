//! Whether two files say the same reference system, one by its number in EPSG and the other in WKT, as writers of different age do.

use super::wkt::{Item, Node};

/// Systems of places and of heights by their numbers in EPSG, as far as they are said.
#[derive(Clone, Copy, Default, PartialEq)]
struct Codes {
    place: Option<u32>,
    height: Option<u32>,
}

/// Whether the systems are one, as far as that can be told: by numbers where both say them, else by name. Both are WKT, `EPSG:`
/// and a number, or words.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    let (own, other) = (codes(a), codes(b));
    let differ = |a: Option<u32>, b: Option<u32>| a.zip(b).is_some_and(|(a, b)| a != b);
    if differ(own.place, other.place) || differ(own.height, other.height) {
        return false;
    }
    own.place.is_some() && own.place == other.place || name(a) == name(b)
}

/// What people call a system: of WKT its first words in quotes.
pub(crate) fn name(crs: &str) -> &str {
    crs.split('"').nth(1).unwrap_or(crs)
}

fn codes(crs: &str) -> Codes {
    if let Some(numbers) = crs.strip_prefix("EPSG:") {
        let mut numbers = numbers.split('+').map(|number| number.parse().ok());
        return Codes { place: numbers.next().flatten(), height: numbers.next().flatten() };
    }
    let Some(root) = Node::parse(crs) else { return Codes::default() };
    let place = ["PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOGCS", "GEOGCRS", "GEODCRS"];
    let place = place.iter().find_map(|keyword| root.find(&[keyword]));
    let height = root.find(&["VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"]);
    Codes { place: place.and_then(code), height: height.and_then(code) }
}

/// The number of a system in EPSG, where it says one itself.
fn code(system: &Node) -> Option<u32> {
    let own = system.children().find(|child| matches!(&*child.keyword, "AUTHORITY" | "ID"))?;
    match &own.items[..] {
        [Item::Text(authority), number, ..] if authority.eq_ignore_ascii_case("EPSG") => match number {
            Item::Text(digits) => digits.parse().ok(),
            Item::Number(number) => Some(*number as u32),
            Item::Node(_) => None,
        },
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::is_same;

    #[test]
    fn a_number_and_the_text_that_says_it_are_one_system() {
        let utm =
            r#"PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",AUTHORITY["EPSG","4326"]],AUTHORITY["EPSG","32632"]]"#;
        let new = r#"PROJCRS["WGS 84 / UTM zone 32N",BASEGEOGCRS["WGS 84",ID["EPSG",4326]],ID["EPSG",32632]]"#;
        let compound = format!(r#"COMPD_CS["x",{utm},VERT_CS["h",AUTHORITY["EPSG","5773"]]]"#);
        for (a, b) in [("EPSG:32632", utm), (utm, new), ("EPSG:32632+5773", &compound), (&compound, utm), ("x", "x")] {
            assert!(is_same(a, b) && is_same(b, a), "{a} {b}");
        }
        for (a, b) in [("EPSG:32633", utm), ("EPSG:32632+5783", &compound), ("x", "y"), ("x", utm)] {
            assert!(!is_same(a, b) && !is_same(b, a), "{a} {b}");
        }
    }
}
