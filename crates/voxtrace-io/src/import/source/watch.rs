//! Reading that ends when nobody waits for the scene any more. Readers call each other through many hands, so whoever asks is known to the
//! thread that reads, and each input that is opened there takes it along.

use std::cell::RefCell;
use std::io::{Error, Read, Seek, SeekFrom};
use std::sync::Arc;
use voxtrace_voxelize::{ImportError, Stopped};

type GoesOn = Arc<dyn Fn() -> bool + Send + Sync>;

thread_local! {
    static GOES_ON: RefCell<Option<GoesOn>> = const { RefCell::new(None) };
}

/// Reads as long as `goes_on` says so. Once it does not, readers that this thread calls in `read` end soon, wherever they are in their file, with
/// an [`ImportError`] whose kind is [`Stopped`](voxtrace_voxelize::ImportErrorKind::Stopped).
///
/// # Errors
/// Those of `read`.
pub fn read_while<T>(
    goes_on: impl Fn() -> bool + Send + Sync + 'static,
    read: impl FnOnce() -> Result<T, ImportError>,
) -> Result<T, ImportError> {
    /// Puts back what was before, also where `read` panics.
    struct Before(Option<GoesOn>);
    impl Drop for Before {
        fn drop(&mut self) {
            GOES_ON.set(self.0.take());
        }
    }
    let _before = Before(GOES_ON.replace(Some(Arc::new(goes_on))));
    read()
}

/// Asks whether reading goes on.
#[derive(Clone, Default)]
pub(crate) struct Watch(Option<GoesOn>);

impl Watch {
    /// What this thread's reading asks.
    pub fn of_thread() -> Self {
        Self(GOES_ON.with_borrow(Clone::clone))
    }

    /// Whether somebody waits for what is read.
    pub fn goes_on(&self) -> bool {
        self.0.as_ref().is_none_or(|goes_on| goes_on())
    }

    /// Fails with [`Stopped`] where reading is to end.
    pub fn check(&self) -> std::io::Result<()> {
        if self.goes_on() { Ok(()) } else { Err(Error::other(Stopped)) }
    }
}

/// Something to read, as long as that is wanted.
pub(crate) struct Watched<R> {
    pub inner: R,
    pub watch: Watch,
}

impl<R: Read> Read for Watched<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        self.watch.check()?;
        self.inner.read(buffer)
    }
}

impl<R: Seek> Seek for Watched<R> {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        self.inner.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::import::source::input::Input;
    use std::path::Path;
    use std::sync::atomic::{AtomicU32, Ordering};
    use voxtrace_voxelize::{ImportErrorKind, Limits};

    const LINES: usize = 100_000;

    /// Goes on until it was asked so often.
    fn asked(most: u32) -> impl Fn() -> bool + Send + Sync + 'static {
        let count = AtomicU32::new(0);
        move || count.fetch_add(1, Ordering::Relaxed) < most
    }

    /// The lines that were read, in any of the ways in which readers read.
    fn lines(mut input: Input) -> Result<usize, ImportError> {
        let mut count = 0;
        while input.line()?.is_some() {
            count += 1;
        }
        Ok(count)
    }

    #[test]
    fn reading_ends_where_nobody_waits_for_it_whatever_the_way() {
        let bytes = b"1 2 3 4 5 6 7\n".repeat(LINES);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lines.xyz");
        std::fs::write(&path, &bytes).unwrap();
        let (name, limits) = (Path::new("lines"), Limits::default());
        let by_lines = |most| read_while(asked(most), || lines(Input::of_bytes(&bytes, name, &limits)?));
        let decoded = |most| {
            read_while(asked(most), || {
                let inner = Watched { inner: &bytes[..], watch: Watch::of_thread() };
                lines(Input::of_decoder(Box::new(inner), name, &limits))
            })
        };
        let whole =
            |most| read_while(asked(most), || Ok(Input::open(&path, &limits)?.rest()?.len() / (bytes.len() / LINES)));
        let seekable = |most| {
            read_while(asked(most), || {
                let (mut stream, _) = Input::open(&path, &limits)?.seekable()?;
                let mut text = String::new();
                stream.read_to_string(&mut text).map_err(|error| ImportError::io(&path, error))?;
                Ok(text.lines().count())
            })
        };
        type Way<'a> = &'a dyn Fn(u32) -> Result<usize, ImportError>;
        let ways: [(&str, Way); 4] =
            [("lines", &by_lines), ("a decoder", &decoded), ("whole", &whole), ("seekable", &seekable)];
        for (way, read) in ways {
            assert_eq!(read(u32::MAX).unwrap(), LINES, "{way}: nobody asks for an end");
            for most in [0, u32::from(way != "whole")] {
                let error = read(most).unwrap_err();
                assert!(matches!(error.kind, ImportErrorKind::Stopped), "{way}: {error}");
            }
        }
    }

    #[test]
    fn what_is_read_afterwards_is_read_to_its_end() {
        let bytes = b"1 2 3\n".repeat(10);
        let read = || lines(Input::of_bytes(&bytes, Path::new("lines"), &Limits::default())?);
        let within = read_while(|| true, || read_while(|| false, read).map_or_else(|_| read(), Ok));
        assert_eq!((within.unwrap(), read().unwrap()), (10, 10));
        let panicked =
            std::panic::catch_unwind(|| read_while(|| false, || -> Result<(), ImportError> { panic!("damage") }));
        assert!(panicked.is_err() && read().is_ok());
    }
}
