//! Reading piece by piece, from files and from memory.

use super::*;

fn input(bytes: &[u8]) -> Input<'_> {
    Input::of_bytes(bytes, Path::new("bytes"), &Limits::default()).unwrap()
}

#[test]
fn lines_end_with_either_sign_or_the_file() {
    let mut input = input(b"one\r\n\ntwo\nthree");
    let mut lines = Vec::new();
    while let Some(line) = input.line().unwrap() {
        lines.push(String::from_utf8_lossy(line).into_owned());
    }
    assert_eq!(lines, ["one", "", "two", "three"]);
    assert_eq!((input.offset(), input.remaining()), (15, Some(0)));
}

#[test]
fn what_marks_a_text_as_utf_8_is_no_part_of_its_first_line_alone() {
    let mut input = input("\u{feff}one\n\u{feff}two".as_bytes());
    assert_eq!(input.line().unwrap(), Some(&b"one"[..]));
    assert_eq!((input.offset(), input.line().unwrap()), (7, Some("\u{feff}two".as_bytes())));
}

#[test]
fn pieces_cross_the_border_of_the_window() {
    let bytes: Vec<u8> = (0..3 * WINDOW + 5).map(|i| (i % 251) as u8).collect();
    let mut input = input(&bytes);
    let mut at = 0;
    for count in [1, WINDOW - 1, 7, WINDOW + 3, 2] {
        assert_eq!(input.peek(count).unwrap(), &bytes[at..at + count]);
        assert_eq!(input.take(count, "a piece").unwrap(), &bytes[at..at + count]);
        at += count;
    }
    assert_eq!(input.rest().unwrap(), &bytes[at..]);
}

#[test]
fn a_buffer_is_filled_from_the_window_and_from_behind_it() {
    let bytes: Vec<u8> = (0..2 * WINDOW + 5).map(|i| (i % 241) as u8).collect();
    let mut input = input(&bytes);
    input.take(3, "a head").unwrap();
    let mut buffer = vec![0; WINDOW + 9];
    input.take_into(&mut buffer, "a body").unwrap();
    assert!(buffer == bytes[3..WINDOW + 12]);
    assert_eq!(input.offset(), (WINDOW + 12) as u64);
    assert_eq!(input.take(2, "a foot").unwrap(), &bytes[WINDOW + 12..WINDOW + 14]);
    let error = input.take_into(&mut buffer, "too much").unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Truncated(what) if what == "too much"));
    assert_eq!(error.offset, Some(bytes.len() as u64));
}

#[test]
fn bytes_of_a_file_are_gone_over_as_those_in_memory() {
    let bytes: Vec<u8> = (0..5 * WINDOW + 5).map(|i| (i % 239) as u8).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bytes");
    std::fs::write(&path, &bytes).unwrap();
    let read = |mut input: Input, skips: [u64; 2]| {
        input.take(3, "a head")?;
        input.skip(skips[0], "a part")?;
        let first = input.take(2, "two bytes")?.to_vec();
        input.skip(skips[1], "another part")?;
        let mut more = [0; 7];
        input.take_into(&mut more, "seven bytes")?;
        Ok::<_, ImportError>((first, more, input.offset(), input.remaining()))
    };
    let whole = bytes.len() as u64;
    for skips in [[0, 0], [5, 9], [WINDOW as u64 + 1, 7], [3, 3 * WINDOW as u64], [whole - 12, 0]] {
        let found = read(Input::open(&path, &Limits::default()).unwrap(), skips).unwrap();
        assert_eq!(found, read(input(&bytes), skips).unwrap(), "{skips:?}");
    }
    for skips in [[whole, 0], [9, whole - 10], [u64::MAX, 0]] {
        let error = read(Input::open(&path, &Limits::default()).unwrap(), skips).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_)) && error.offset == Some(whole), "{error}");
    }
}

#[test]
fn the_end_inside_a_piece_is_told_with_its_byte() {
    let mut input = input(b"12345");
    input.take(2, "a head").unwrap();
    let error = input.take(4, "a body").unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Truncated(what) if what == "a body"));
    assert_eq!(error.offset, Some(5));
}

#[test]
fn more_bytes_than_allowed_are_an_error_for_files_and_memory() {
    let limits = Limits { bytes: 4, ..Limits::default() };
    assert!(Input::of_bytes(b"12345", Path::new("bytes"), &limits).is_err());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("five");
    std::fs::write(&path, "12345").unwrap();
    assert!(Input::open(&path, &limits).is_err());
    assert!(Input::open(folder.path(), &limits).is_err());
}

#[test]
fn what_no_option_allows_is_not_called_a_limit_that_one_may_lift() {
    let error = input(b"12345").take(LONGEST + 1, "a body").unwrap_err();
    let text = error.to_string();
    assert!(
        matches!(error.kind, ImportErrorKind::Unsupported(_)) && text.contains("fixed limit of 67108864"),
        "{text}"
    );
}
