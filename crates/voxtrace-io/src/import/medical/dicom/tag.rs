//! Tags, group and element (PS3.6), of what is used.

pub(super) const TRANSFER_SYNTAX: u32 = 0x0002_0010;
/// Of a directory of a medium: its records, and the file that one is about.
pub(super) const DIRECTORY_RECORDS: u32 = 0x0004_1220;
pub(super) const REFERENCED_FILE: u32 = 0x0004_1500;
pub(super) const IMAGE_TYPE: u32 = 0x0008_0008;
pub(super) const MODALITY: u32 = 0x0008_0060;
pub(super) const SERIES_DESCRIPTION: u32 = 0x0008_103e;
pub(super) const SLICE_THICKNESS: u32 = 0x0018_0050;
pub(super) const SLICE_DISTANCE: u32 = 0x0018_0088;
/// Of Siemens: how many tiles a mosaic has, and the header that says it in older files, in the first or second private block.
pub(super) const MOSAIC_COUNT: u32 = 0x0019_100a;
pub(super) const CSA_HEADER: u32 = 0x0029_1010;
pub(super) const CSA_HEADER_BEHIND: u32 = 0x0029_1110;
pub(super) const SERIES: u32 = 0x0020_000e;
pub(super) const SERIES_NUMBER: u32 = 0x0020_0011;
pub(super) const INSTANCE_NUMBER: u32 = 0x0020_0013;
pub(super) const POSITION: u32 = 0x0020_0032;
pub(super) const ORIENTATION: u32 = 0x0020_0037;
pub(super) const SAMPLES: u32 = 0x0028_0002;
pub(super) const PHOTOMETRIC: u32 = 0x0028_0004;
pub(super) const PLANAR: u32 = 0x0028_0006;
pub(super) const FRAMES: u32 = 0x0028_0008;
pub(super) const ROWS: u32 = 0x0028_0010;
pub(super) const COLUMNS: u32 = 0x0028_0011;
pub(super) const PIXEL_SPACING: u32 = 0x0028_0030;
pub(super) const BITS_ALLOCATED: u32 = 0x0028_0100;
pub(super) const BITS_STORED: u32 = 0x0028_0101;
pub(super) const HIGH_BIT: u32 = 0x0028_0102;
pub(super) const SIGNED: u32 = 0x0028_0103;
pub(super) const PALETTE_OF_RED: u32 = 0x0028_1101;
pub(super) const RED_ENTRIES: u32 = 0x0028_1201;
pub(super) const GREEN_ENTRIES: u32 = 0x0028_1202;
pub(super) const BLUE_ENTRIES: u32 = 0x0028_1203;
/// The entries in segments.
pub(super) const RED_SEGMENTS: u32 = 0x0028_1221;
pub(super) const GREEN_SEGMENTS: u32 = 0x0028_1222;
pub(super) const BLUE_SEGMENTS: u32 = 0x0028_1223;
/// Sequences within the groups of frames that hold what is read of them.
pub(super) const PLACE_GROUPS: [u32; 5] = [0x0020_9113, 0x0020_9116, 0x0028_9110, 0x0028_9145, 0x0062_000a];
/// Of segmentations: their kind, the number of the segment that a frame is of, and what stands for all of a place.
pub(super) const SEGMENTATION: u32 = 0x0062_0001;
pub(super) const SEGMENT: u32 = 0x0062_000b;
pub(super) const WHOLE_SHARE: u32 = 0x0062_000e;
pub(super) const INTERCEPT: u32 = 0x0028_1052;
pub(super) const SLOPE: u32 = 0x0028_1053;
pub(super) const FRAME_OFFSETS: u32 = 0x3004_000c;
pub(super) const DOSE_SCALING: u32 = 0x3004_000e;
pub(super) const SHARED_GROUPS: u32 = 0x5200_9229;
pub(super) const FRAME_GROUPS: u32 = 0x5200_9230;
pub(super) const FLOAT_PIXELS: u32 = 0x7fe0_0008;
pub(super) const DOUBLE_PIXELS: u32 = 0x7fe0_0009;
pub(super) const PIXELS: u32 = 0x7fe0_0010;
pub(super) const ITEM: u32 = 0xfffe_e000;
pub(super) const ITEM_END: u32 = 0xfffe_e00d;
pub(super) const SEQUENCE_END: u32 = 0xfffe_e0dd;

/// What is kept of a file.
pub(super) const WANTED: [u32; 42] = [
    TRANSFER_SYNTAX,
    REFERENCED_FILE,
    IMAGE_TYPE,
    MOSAIC_COUNT,
    CSA_HEADER,
    CSA_HEADER_BEHIND,
    PALETTE_OF_RED,
    RED_ENTRIES,
    GREEN_ENTRIES,
    BLUE_ENTRIES,
    RED_SEGMENTS,
    GREEN_SEGMENTS,
    BLUE_SEGMENTS,
    MODALITY,
    SERIES_DESCRIPTION,
    SLICE_THICKNESS,
    SLICE_DISTANCE,
    SERIES,
    SERIES_NUMBER,
    INSTANCE_NUMBER,
    POSITION,
    ORIENTATION,
    SAMPLES,
    PHOTOMETRIC,
    PLANAR,
    FRAMES,
    ROWS,
    COLUMNS,
    PIXEL_SPACING,
    BITS_ALLOCATED,
    BITS_STORED,
    HIGH_BIT,
    SIGNED,
    INTERCEPT,
    SLOPE,
    SEGMENTATION,
    SEGMENT,
    WHOLE_SHARE,
    FRAME_OFFSETS,
    DOSE_SCALING,
    SHARED_GROUPS,
    FRAME_GROUPS,
];
