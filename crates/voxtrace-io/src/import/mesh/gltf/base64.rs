//! Base64 (RFC 4648, section 4), as `data:` URIs have it.

/// The bytes of a `data:` URI, `None` where it is none, or none in base64.
pub(super) fn of_data_uri(uri: &str) -> Option<Vec<u8>> {
    let (kind, data) = uri.strip_prefix("data:")?.split_once(',')?;
    kind.ends_with(";base64").then(|| decode(data))?
}

fn decode(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=');
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 3);
    let (mut pending, mut bits) = (0u32, 0);
    for byte in text.bytes() {
        let value = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        pending = pending << 6 | u32::from(value);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            bytes.push((pending >> bits) as u8);
            pending &= (1 << bits) - 1;
        }
    }
    // A single sign at the end says six bits: no byte.
    (bits < 6).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_samples_of_the_standard_are_decoded() {
        let samples =
            [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmFy", "foobar"), ("Zm9vYg", "foob")];
        for (text, bytes) in samples {
            assert_eq!(decode(text).as_deref(), Some(bytes.as_bytes()), "{text}");
        }
        assert!(decode("Z").is_none() && decode("Zm9v!").is_none() && decode("Zg==Zg").is_none());
        assert_eq!(of_data_uri("data:application/octet-stream;base64,/+8=").unwrap(), [0xff, 0xef]);
        assert!(of_data_uri("data:text/plain,hello").is_none() && of_data_uri("a.bin").is_none());
    }
}
