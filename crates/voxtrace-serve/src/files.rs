//! Files as they are, with what browsers ask for to take them piece by piece: `Range`, `ETag`, `If-Range` and `If-None-Match` (RFC 9110, sections 13 and 14).

use crate::places::{Place, stamp_of};
use crate::refusal::Refusal;
use axum::body::Body;
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::io::SeekFrom;
use std::ops::RangeInclusive;
use tokio::fs::File;
use tokio::io::{AsyncReadExt, AsyncSeekExt};
use tokio_util::io::ReaderStream;

/// Bytes that are read at once.
const PART: usize = 256 << 10;

/// Answers with a file, or the part of it that is asked for; parts are asked for by GET alone.
pub async fn respond(
    place: &Place,
    method: &Method,
    asked: &HeaderMap,
    kind: &'static str,
) -> Result<Response, Refusal> {
    let nothing = |_| Refusal::nothing(&place.name);
    let mut file = File::open(&place.path).await.map_err(nothing)?;
    // Of what was opened: another file may have taken the place of the one that was found.
    let (length, written) = stamp_of(&file.metadata().await.map_err(nothing)?);
    let tag = format!("\"{length:x}-{written:x}\"");
    let common = |response: &mut Response| {
        let headers = response.headers_mut();
        headers.insert(header::ACCEPT_RANGES, HeaderValue::from_static("bytes"));
        headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
        headers.insert(header::ETAG, HeaderValue::from_str(&tag).expect("digits"));
    };
    // A list of tags, of which weak ones count, too, or `*`.
    let known = asked.get(header::IF_NONE_MATCH).and_then(|known| known.to_str().ok()).unwrap_or_default();
    let is_known = known.split(',').map(str::trim).any(|known| known == "*" || known.trim_start_matches("W/") == tag);
    if is_known {
        let mut response = StatusCode::NOT_MODIFIED.into_response();
        common(&mut response);
        return Ok(response);
    }
    let wanted = if *method == Method::GET { range_of(asked, &tag, length) } else { Wanted::All };
    let range = match wanted {
        Wanted::All => None,
        Wanted::Part(range) => Some(range),
        Wanted::Nothing => {
            let mut response = Refusal::new(StatusCode::RANGE_NOT_SATISFIABLE, "the file is shorter").into_response();
            common(&mut response);
            response.headers_mut().insert(header::CONTENT_RANGE, text(&format!("bytes */{length}")));
            return Ok(response);
        }
    };
    let (start, count) = range.as_ref().map_or((0, length), |range| (*range.start(), range.end() - range.start() + 1));
    let failed = |error: std::io::Error| Refusal::failed(format!("{}: {error}", place.name));
    file.seek(SeekFrom::Start(start)).await.map_err(failed)?;
    let mut response = Body::from_stream(ReaderStream::with_capacity(file.take(count), PART)).into_response();
    common(&mut response);
    let headers = response.headers_mut();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    headers.insert(header::CONTENT_LENGTH, count.into());
    if let Some(range) = range {
        let value = format!("bytes {}-{}/{length}", range.start(), range.end());
        headers.insert(header::CONTENT_RANGE, text(&value));
        *response.status_mut() = StatusCode::PARTIAL_CONTENT;
    }
    Ok(response)
}

fn text(value: &str) -> HeaderValue {
    HeaderValue::from_str(value).expect("digits")
}

/// What a request wants of a file.
#[derive(Debug, PartialEq, Eq)]
enum Wanted {
    All,
    Part(RangeInclusive<u64>),
    Nothing,
}

/// Several ranges, a range of another version of the file, and what is no range at all are answered by the whole file, as servers may.
fn range_of(asked: &HeaderMap, tag: &str, length: u64) -> Wanted {
    let is_of_this = asked.get(header::IF_RANGE).is_none_or(|known| known.as_bytes() == tag.as_bytes());
    let range = asked.get(header::RANGE).filter(|_| is_of_this).and_then(|range| range.to_str().ok());
    let Some((start, end)) = range.and_then(|range| range.strip_prefix("bytes=")?.split_once('-')) else {
        return Wanted::All;
    };
    let (start, end) = (start.trim(), end.trim());
    let range = match (start.parse::<u64>(), end.parse::<u64>()) {
        (Ok(start), Ok(end)) if start <= end => start..=end.min(length.saturating_sub(1)),
        (Ok(start), Err(_)) if end.is_empty() => start..=length.saturating_sub(1),
        // The last bytes: all where there are fewer.
        (Err(_), Ok(count)) if start.is_empty() => length.saturating_sub(count)..=length.saturating_sub(1),
        _ => return Wanted::All,
    };
    if *range.start() >= length { Wanted::Nothing } else { Wanted::Part(range) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_takes_anothers_place_comes_whole_and_under_its_own_tag() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.vox");
        std::fs::write(&path, "old").unwrap();
        let found = Place { name: "a.vox".into(), metadata: path.metadata().unwrap(), path: path.clone() };
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        runtime.block_on(async {
            let old = respond(&found, &Method::GET, &HeaderMap::new(), "a").await.unwrap();
            std::fs::write(folder.path().join("new"), "new and longer").unwrap();
            std::fs::rename(folder.path().join("new"), &path).unwrap();
            let new = respond(&found, &Method::GET, &HeaderMap::new(), "a").await.unwrap();
            assert_ne!(new.headers()[header::ETAG], old.headers()[header::ETAG]);
            assert_eq!(new.headers()[header::CONTENT_LENGTH], "14");
            assert_eq!(axum::body::to_bytes(new.into_body(), 99).await.unwrap(), "new and longer");
        });
    }

    #[test]
    fn ranges_are_those_of_the_standard() {
        let of = |range: &str, known: Option<&str>, length| {
            let mut headers = HeaderMap::new();
            headers.insert(header::RANGE, range.parse().unwrap());
            if let Some(known) = known {
                headers.insert(header::IF_RANGE, known.parse().unwrap());
            }
            range_of(&headers, "\"a\"", length)
        };
        assert_eq!(of("bytes=0-9", None, 100), Wanted::Part(0..=9));
        assert_eq!(of("bytes=90-", None, 100), Wanted::Part(90..=99));
        assert_eq!(of("bytes=-10", None, 100), Wanted::Part(90..=99));
        assert_eq!(of("bytes=-1000", None, 100), Wanted::Part(0..=99));
        assert_eq!(of("bytes=-0", None, 100), Wanted::Nothing);
        assert_eq!(of("bytes=9-8", None, 100), Wanted::All, "no range");
        assert_eq!(of("bytes=90-900", None, 100), Wanted::Part(90..=99));
        assert_eq!(of("bytes=99-99", Some("\"a\""), 100), Wanted::Part(99..=99));
        assert_eq!(of("bytes=0-9", Some("\"b\""), 100), Wanted::All, "of another version");
        assert_eq!(of("bytes=100-", None, 100), Wanted::Nothing);
        assert_eq!(of("bytes=0-0", None, 0), Wanted::Nothing);
        assert_eq!(of("bytes=0-1,4-5", None, 100), Wanted::All, "several");
        assert_eq!(of("lines=0-1", None, 100), Wanted::All);
        assert_eq!(of("bytes=18446744073709551615-", None, 100), Wanted::Nothing);
    }
}
