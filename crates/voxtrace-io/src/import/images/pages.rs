//! The pages of a TIFF that are slices of one volume, decoded one by one as they are asked for.

use super::allowance::{self, Packing};
use super::contiguous::Contiguous;
use super::hyperstack::Hyperstack;
use super::page::{bits_of, decoder_limits, plane};
use super::planes::{Choice, Plane, Wanted, is_about_another, stack, tiff_spacing};
use super::unpacked::Unpacked;
use crate::import::source::guard::guarded;
use crate::import::source::opened;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use tiff::TiffError;
use tiff::decoder::Decoder;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

type PageDecoder = Decoder<Unpacked<BufReader<File>>>;

/// A file of pages.
pub(crate) struct Pages {
    path: PathBuf,
    /// Columns and rows of each page.
    pub size: [usize; 2],
    /// Which pages of the file are read, in the order of the slices.
    pub pages: Vec<usize>,
    /// Pages of another size than the first.
    pub left_out: usize,
    pub spacing: Option<[f64; 3]>,
    pub stack: Option<Hyperstack>,
    /// Where all lie one behind the other, which then are not decoded.
    pub contiguous: Option<Contiguous>,
    /// The decoder, and the page at which it is.
    decoder: Option<(PageDecoder, usize)>,
    limits: Limits,
}

impl Pages {
    /// Goes through a file's pages; `None` where they are one, or several channels that are shown together.
    pub fn open(path: &Path, choice: Choice, limits: &Limits) -> Result<Option<Self>, ImportError> {
        let found = guarded(|| Self::listed(path, choice, limits).map_err(|error| error.to_string()));
        found.map_err(|what| ImportError::at(path, 0, ImportErrorKind::Malformed(what)))
    }

    fn listed(path: &Path, choice: Choice, limits: &Limits) -> Result<Option<Self>, TiffError> {
        let (mut decoder, packing) = opened(path, limits)?;
        let (width, height) = decoder.dimensions()?;
        let big_endian = decoder.byte_order() == tiff::tags::ByteOrder::BigEndian;
        let pixels = u64::from(width) * u64::from(height);
        let bits = u64::from(bits_of(decoder.colortype()?));
        let length = std::fs::metadata(path)?.len();
        allowance::check((width, height, pixels), bits, length, packing, limits)
            .map_err(|refused| TiffError::IoError(std::io::Error::other(refused.to_string())))?;
        let contiguous = Contiguous::of(&mut decoder).filter(|_| packing == Packing::Tiff);
        let stack = stack(&mut decoder, big_endian, contiguous.is_some());
        if stack.as_ref().is_some_and(|stack| stack.scattered().is_some()) {
            return Ok(None);
        }
        let wanted = match stack.as_ref().filter(|stack| !stack.is_plain()) {
            Some(stack) => {
                Some(Wanted::of(stack, choice).map_err(|what| TiffError::IoError(std::io::Error::other(what)))?)
            }
            None => None,
        };
        if wanted
            .as_ref()
            .zip(stack.as_ref())
            .is_some_and(|(wanted, stack)| wanted.channel.is_none() && stack.sizes[0] > 1)
            || contiguous.is_some() && wanted.is_some()
        {
            return Ok(None);
        }
        let spacing = tiff_spacing(&mut decoder);
        let size = [width as usize, height as usize];
        let (mut pages, mut left_out, mut page) = (Vec::new(), 0, 0);
        loop {
            let place = stack.as_ref().and_then(|stack| stack.place(page));
            let is_wanted = wanted.as_ref().is_none_or(|wanted| place.is_some_and(|place| wanted.has(place)));
            let is_like_first = decoder.dimensions()? == (width, height);
            if page > 0 && is_about_another(&mut decoder, is_like_first) {
                // An overview or a mask.
            } else if is_wanted && is_like_first {
                pages.push((place.filter(|_| wanted.is_some()).map_or(0, |place| place[1]), page));
            } else if is_wanted {
                left_out += 1;
            }
            if !decoder.more_images() {
                break;
            }
            page += 1;
            if page as u64 >= limits.items {
                return Err(TiffError::IoError(std::io::Error::other("TIFF: more pages than allowed")));
            }
            decoder.next_image()?;
        }
        pages.sort_unstable();
        let pages: Vec<usize> = pages.into_iter().map(|(_, page)| page).collect();
        let is_whole = wanted.is_none() || stack.as_ref().is_some_and(|stack| stack.sizes[1] == pages.len());
        let is_volume = contiguous.is_some() || pages.len() + left_out > 1 && is_whole;
        let path = path.to_path_buf();
        let limits = *limits;
        Ok(is_volume.then_some(Self { path, size, pages, left_out, spacing, stack, contiguous, decoder: None, limits }))
    }

    /// Decodes a slice.
    pub fn slice(&mut self, slice: usize) -> Result<Plane, ImportError> {
        let page = self.pages[slice];
        let [width, height] = self.size;
        let read = || {
            let mut ready = match self.decoder.take().filter(|(_, at)| *at <= page) {
                Some(ready) => ready,
                None => (opened(&self.path, &self.limits)?.0, 0),
            };
            while ready.1 < page {
                ready.0.next_image()?;
                ready.1 += 1;
            }
            let mut decoder = ready.0.with_limits(decoder_limits((width * height) as u64, &self.limits));
            let plane = plane(&mut decoder, width, height)?;
            self.decoder = Some((decoder, page));
            Ok(plane)
        };
        let found: Result<Plane, String> = guarded(|| { read }().map_err(|error: TiffError| error.to_string()));
        found.map_err(|what| ImportError::at(&self.path, 0, ImportErrorKind::Malformed(format!("page {page}: {what}"))))
    }
}

/// A file's decoder, and how its pixels are packed.
fn opened(path: &Path, limits: &Limits) -> Result<(PageDecoder, Packing), TiffError> {
    opened::note(path);
    let unpacked = Unpacked::of(BufReader::with_capacity(1 << 18, File::open(path)?), limits)?;
    let packing = unpacked.allowance();
    Ok((Decoder::new(unpacked)?, packing))
}
