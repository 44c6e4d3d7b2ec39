//! Pages of a TIFF that are more than slices: channels and time points, as ImageJ's description or OME-XML (Goldberg et al., "The Open
//! Microscopy Environment (OME) Data Model and XML file", 2005) says in the first page, with what it says of lengths and colours.

use crate::import::samples::channels::Channel;

/// Millimetres of units, as ImageJ and OME write them.
const UNITS: [(&str, f64); 16] = [
    ("nm", 1e-6),
    ("nanometer", 1e-6),
    ("µm", 1e-3),
    ("μm", 1e-3),
    ("um", 1e-3),
    ("\\u00B5m", 1e-3),
    ("\\u00b5m", 1e-3),
    ("micron", 1e-3),
    ("microns", 1e-3),
    ("micrometer", 1e-3),
    ("mm", 1.0),
    ("cm", 10.0),
    ("m", 1e3),
    ("inch", 25.4),
    ("in", 25.4),
    ("Å", 1e-7),
];

/// Most channels, slices, time points or pages.
const MOST: usize = 1 << 20;

/// What the first page says about all.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Hyperstack {
    /// How many channels, slices and time points there are.
    pub sizes: [usize; 3],
    /// Which channel, slice and time point each page is.
    pages: Pages,
    /// Between pixels and slices, each in millimetres or in no unit, where it is said.
    pub spacing: [Option<f64>; 3],
    /// Whether they are millimetres.
    pub has_unit: bool,
    /// What is said about channels.
    pub channels: Vec<Channel>,
    /// Names of the files that its pages lie in, where they are several.
    pub files: Vec<String>,
}

/// Which page is what.
#[derive(Clone, Debug, PartialEq)]
enum Pages {
    /// Axes that run faster come first: 0 are channels, 1 slices, 2 time points.
    Order([usize; 3]),
    /// Each by itself.
    Listed(Vec<Option<[usize; 3]>>),
}

impl Default for Pages {
    fn default() -> Self {
        Self::Order([0, 1, 2])
    }
}

impl Hyperstack {
    /// What a page's description says; `None` where it is of neither kind.
    pub fn of(description: &str) -> Option<Self> {
        if description.starts_with("ImageJ=") {
            return Some(Self::of_imagej(description));
        }
        let is_ome = description.contains("<OME") || description.contains(":OME ");
        if is_ome { Self::of_ome(description) } else { None }
    }

    fn of_imagej(description: &str) -> Self {
        let word = |key: &str| {
            let mut lines = description.lines().filter_map(|line| line.split_once('='));
            lines.find(|(own, _)| own.trim() == key).map(|(_, value)| value.trim())
        };
        let count =
            |key| word(key).and_then(|text| text.parse().ok()).filter(|count: &usize| (1..=MOST).contains(count));
        let [channels, slices, frames] = ["channels", "slices", "frames"].map(count);
        // Stacks of one kind say their pages alone.
        let rest = count("images").unwrap_or(1) / channels.unwrap_or(1).saturating_mul(frames.unwrap_or(1)).max(1);
        let sizes = [channels.unwrap_or(1), slices.unwrap_or(rest.max(1)), frames.unwrap_or(1)];
        let factor = word("unit").and_then(millimetres);
        // ImageJ does not write a distance of one unit.
        let one = (word("unit").is_some() && sizes[1] > 1).then_some(1.0);
        let distance = word("spacing").and_then(|text| text.parse::<f64>().ok()).map(f64::abs).or(one);
        let distance = distance.map(|distance| distance * factor.unwrap_or(1.0));
        Self { sizes, spacing: [None, None, distance], has_unit: factor.is_some(), ..Self::default() }
    }

    /// Sets what pixels are apart, in the unit of the description.
    pub fn set_pixels(&mut self, description: &str, [x, y]: [f64; 2]) {
        let unit = description.lines().find_map(|line| line.strip_prefix("unit="));
        let factor = unit.and_then(|unit| millimetres(unit.trim())).unwrap_or(1.0);
        (self.spacing[0], self.spacing[1]) = (Some(x * factor), Some(y * factor));
    }

    fn of_ome(description: &str) -> Option<Self> {
        let pixels = tags(description, "Pixels").next()?;
        let count = |key| attribute(pixels, key)?.parse().ok().filter(|count| (1..=MOST).contains(count));
        let samples = tags(description, "Channel").next().and_then(|tag| attribute(tag, "SamplesPerPixel"));
        let samples = samples.and_then(|samples| samples.parse().ok()).filter(|&samples: &usize| samples > 0);
        let sizes =
            [count("SizeC")? / samples.unwrap_or(1), count("SizeZ")?, count("SizeT")?].map(|size: usize| size.max(1));
        let order = attribute(pixels, "DimensionOrder").unwrap_or_else(|| "XYCZT".into());
        let order: Vec<usize> = order.chars().filter_map(|axis| "CZT".find(axis)).collect();
        let order: [usize; 3] = order.try_into().unwrap_or([0, 1, 2]);
        let length = |axis: &str| {
            let number = attribute(pixels, &format!("PhysicalSize{axis}"))?.parse::<f64>().ok()?;
            // Micrometres where no unit is said.
            let unit = attribute(pixels, &format!("PhysicalSize{axis}Unit"));
            Some(number * unit.map_or(Some(1e-3), |unit| millimetres(&unit))?)
        };
        let spacing = ["X", "Y", "Z"].map(length);
        let color = |tag| {
            let [red, green, blue, _] = attribute(tag, "Color")?.parse::<i32>().ok()?.to_be_bytes();
            Some([red, green, blue])
        };
        let channels = tags(description, "Channel").map(|tag| Channel { color: color(tag), window: None }).collect();
        let pages = listed(description, sizes, order).map_or(Pages::Order(order), Pages::Listed);
        let mut files: Vec<String> =
            tags(description, "UUID").filter_map(|tag| attribute(tag, "FileName")).take(MOST).collect();
        files.sort_unstable();
        files.dedup();
        let files = if files.len() > 1 { files } else { Vec::new() };
        Some(Self { sizes, pages, spacing, has_unit: spacing[0].is_some(), channels, files })
    }

    /// The channel, slice and time point of a page; `None` where it is none of them.
    pub fn place(&self, page: usize) -> Option<[usize; 3]> {
        match &self.pages {
            Pages::Order(order) => nth(self.sizes, *order, page),
            Pages::Listed(pages) => *pages.get(page)?,
        }
    }

    /// Whether all pages are slices.
    pub fn is_plain(&self) -> bool {
        self.sizes[0] == 1 && self.sizes[2] == 1
    }

    /// What there is to say where its pages lie in several files.
    pub fn scattered(&self) -> Option<String> {
        let (first, last) = (self.files.first()?, self.files.last()?);
        let count = self.files.len();
        Some(format!(
            "an OME-TIFF whose pages lie in {count} files, from {first} to {last}: join them first, for example by `bfconvert {first} joined.ome.tif`"
        ))
    }

    /// How many pages there are to be.
    pub fn count(&self) -> usize {
        self.sizes.iter().fold(1, |count, &size| count.saturating_mul(size))
    }
}

/// The nth place where the axes run in this order.
fn nth(sizes: [usize; 3], order: [usize; 3], mut page: usize) -> Option<[usize; 3]> {
    let mut place = [0; 3];
    for axis in order {
        place[axis] = page % sizes[axis];
        page /= sizes[axis];
    }
    (page == 0).then_some(place)
}

/// The places of pages that OME-XML lists; `None` where it says that all lie in their order.
fn listed(description: &str, sizes: [usize; 3], order: [usize; 3]) -> Option<Vec<Option<[usize; 3]>>> {
    let mut pages: Vec<Option<[usize; 3]>> = Vec::new();
    let most = sizes.iter().fold(1usize, |count, &size| count.saturating_mul(size)).min(MOST);
    // However many tags there are, each page is said once.
    let mut left = most;
    for tag in tags(description, "TiffData") {
        let number = |key: &str| attribute(tag, key).and_then(|text| text.parse::<usize>().ok());
        let first = ["FirstC", "FirstZ", "FirstT"].map(|key| number(key).unwrap_or(0));
        let start = number("IFD").unwrap_or(0);
        let count = number("PlaneCount").unwrap_or(if number("IFD").is_some() { 1 } else { most });
        if first[0] >= sizes[0] || first[1] >= sizes[1] || first[2] >= sizes[2] || start >= most {
            continue;
        }
        let stride = |axis: usize| {
            order.iter().take_while(|&&other| other != axis).map(|&other| sizes[other]).product::<usize>()
        };
        let offset: usize = (0..3).map(|axis| first[axis] * stride(axis)).sum();
        for n in 0..count.min(left) {
            left -= 1;
            let Some(place) = nth(sizes, order, offset + n) else { break };
            if pages.len() <= start + n {
                pages.resize(start + n + 1, None);
            }
            pages[start + n].get_or_insert(place);
        }
    }
    (!pages.is_empty()).then_some(pages)
}

fn millimetres(unit: &str) -> Option<f64> {
    UNITS.iter().find(|(name, _)| *name == unit).map(|&(_, millimetres)| millimetres)
}

/// The insides of the tags of a name, whatever their prefix.
fn tags<'a>(text: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    text.split('<').filter_map(move |part| {
        let (inside, _) = part.split_once('>')?;
        let (own, rest) = inside.split_once(char::is_whitespace)?;
        (own.rsplit(':').next() == Some(name)).then_some(rest)
    })
}

/// The value of an attribute of a tag.
fn attribute(tag: &str, name: &str) -> Option<String> {
    let mut rest = tag;
    while let Some((key, behind)) = rest.split_once('=') {
        let behind = behind.trim_start();
        let quote = behind.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
        let (value, next) = behind[1..].split_once(quote)?;
        if key.trim() == name {
            return Some(decoded(value));
        }
        rest = next;
    }
    None
}

/// A text without the references of XML that units have.
fn decoded(text: &str) -> String {
    ["&#181;", "&#xB5;", "&#xb5;", "&#956;", "&#x3BC;"]
        .iter()
        .fold(text.to_owned(), |text, micro| text.replace(micro, "µ"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imagej_counts_channels_before_slices_before_time() {
        let text =
            "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nunit=micron\nspacing=0.5\n";
        let mut stack = Hyperstack::of(text).unwrap();
        stack.set_pixels(text, [0.25, 0.125]);
        assert_eq!((stack.sizes, stack.count(), stack.has_unit), ([2, 3, 2], 12, true));
        assert_eq!(
            stack.spacing.map(|length| length.map(|mm| (mm * 1e9).round())),
            [Some(250e3), Some(125e3), Some(500e3)]
        );
        assert_eq!(
            [0, 1, 2, 7, 11].map(|page| stack.place(page).unwrap()),
            [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 1], [1, 2, 1]]
        );
        assert_eq!(stack.place(12), None);
        let text = "ImageJ=1.53t\nimages=3\nslices=3\nunit=mm\n";
        let mut silent = Hyperstack::of(text).unwrap();
        silent.set_pixels(text, [0.25, 0.25]);
        assert_eq!(silent.spacing, [Some(0.25), Some(0.25), Some(1.0)]);
        let plain = Hyperstack::of("ImageJ=1.11a\nimages=10\nslices=10\n").unwrap();
        assert_eq!((plain.sizes, plain.has_unit), ([1, 10, 1], false));
        assert_eq!(Hyperstack::of("ImageJ=1.11a\nimages=7\n").unwrap().sizes, [1, 7, 1]);
        assert_eq!(Hyperstack::of("a camera"), None);
    }

    #[test]
    fn ome_says_order_lengths_and_colours() {
        let text = r#"<?xml version="1.0"?><OME xmlns="x"><Image ID="Image:0"><Pixels DimensionOrder="XYZTC" SizeX="5" SizeY="4" SizeC="2" SizeZ="3" SizeT="2" PhysicalSizeX="0.5"
            PhysicalSizeXUnit="&#181;m" PhysicalSizeY='500' PhysicalSizeYUnit="nm" PhysicalSizeZ="2"><Channel ID="c0" Color="-16776961" SamplesPerPixel="1"/><Channel ID="c1"/>
            <TiffData IFD="0" PlaneCount="12"><UUID FileName="a">b</UUID></TiffData></Pixels></Image></OME>"#;
        let stack = Hyperstack::of(text).unwrap();
        assert_eq!(
            (stack.sizes, stack.spacing, stack.has_unit),
            ([2, 3, 2], [Some(0.0005), Some(0.0005), Some(0.002)], true)
        );
        assert_eq!([0, 1, 3, 6].map(|page| stack.place(page).unwrap()), [[0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]]);
        assert_eq!(stack.channels[0].color, Some([255, 0, 0]));
        assert_eq!(stack.channels[1].color, None);
        assert!(stack.files.is_empty());
        let several = text.replace("</UUID>", r#"</UUID></TiffData><TiffData IFD="0"><UUID FileName="z">c</UUID>"#);
        assert_eq!(Hyperstack::of(&several).unwrap().files, ["a", "z"]);
        // Pages one by one, in any order.
        let turned = text.replace(
            r#"<TiffData IFD="0" PlaneCount="12">"#,
            r#"<TiffData IFD="0" FirstC="1" FirstZ="2"/><TiffData IFD="1" FirstT="1"/><TiffData>"#,
        );
        let stack = Hyperstack::of(&turned).unwrap();
        assert_eq!((stack.place(0), stack.place(1)), (Some([1, 2, 0]), Some([0, 0, 1])));
        for wrong in
            ["<OME>", "<OME ><Pixels >", "<OME ><Pixels SizeC=\"0\" SizeZ=\"1\" SizeT=\"1\">", "<OME ><Pixels SizeC=2"]
        {
            assert_eq!(Hyperstack::of(wrong), None, "{wrong}");
        }
    }
}
