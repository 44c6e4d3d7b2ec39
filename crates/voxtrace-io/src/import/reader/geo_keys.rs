//! The reference system that the keys of a GeoTIFF name (OGC 19-008, "OGC GeoTIFF standard", annex B); LAS files have the same.

/// Number of the tag, or record, with the texts that keys point into.
pub(crate) const WORDS: u16 = 34_737;
/// Keys: of a projected, a geographic and a vertical system, and what people call them.
const PROJECTED: u16 = 3072;
const GEOGRAPHIC: u16 = 2048;
const VERTICAL: u16 = 4096;
const NAMES: [u16; 3] = [3073, 1026, 2049];

/// The system that keys of GeoTIFF name.
pub(crate) fn of_keys(keys: &[u16], words: &str) -> String {
    // Each is its number, where its value lies, how many there are, and the value or its place.
    let keys = || keys.as_chunks::<4>().0.iter().skip(1);
    // 32,767 is what a user defines.
    let is_code = |key: &&[u16; 4], wanted| key[0] == wanted && key[1] == 0 && (1024..32_767).contains(&key[3]);
    let code = |wanted| keys().find(|key| is_code(key, wanted)).map(|key| key[3]);
    if let Some(code_of_plane) = code(PROJECTED).or_else(|| code(GEOGRAPHIC)) {
        let height = code(VERTICAL).map(|code| format!("+{code}")).unwrap_or_default();
        return format!("EPSG:{code_of_plane}{height}");
    }
    let name = NAMES.iter().find_map(|name| {
        let key = keys().find(|key| key[0] == *name && key[1] == WORDS)?;
        let start = usize::from(key[3]);
        words.get(start..start + usize::from(key[2]))
    });
    name.unwrap_or_default().trim_end_matches(['|', ' ', '\0']).to_owned()
}

#[cfg(test)]
mod tests {
    use super::of_keys;

    #[test]
    fn keys_name_a_system_by_number_or_in_words() {
        let head = [1, 1, 0, 3];
        let keys = |keys: &[[u16; 4]]| [&head[..], keys.as_flattened()].concat();
        assert_eq!(of_keys(&keys(&[[1024, 0, 1, 1], [3072, 0, 1, 25_832], [4096, 0, 1, 5773]]), ""), "EPSG:25832+5773");
        assert_eq!(of_keys(&keys(&[[2048, 0, 1, 4326]]), ""), "EPSG:4326");
        let own = [[3072, 0, 1, 32_767], [3073, 34_737, 9, 4]];
        assert_eq!(of_keys(&keys(&own), "abc|my plane|"), "my plane");
        assert_eq!(of_keys(&keys(&[[3073, 34_737, 900, 4]]), "abc"), "");
        assert_eq!(of_keys(&[], ""), "");
    }
}
