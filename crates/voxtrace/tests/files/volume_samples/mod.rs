//! One small volume in every format that is read: a lump of bone in air, samples farther apart along z.

pub mod dicom;

use super::zipped::{bzip2, gzip, zip, zlib};

/// Samples along each axis.
pub const SIZE: [usize; 3] = [9, 8, 7];
/// Millimetres between them.
pub const SPACING: [f64; 3] = [0.5, 0.5, 1.25];
/// Place of the first sample: left, posterior, superior.
pub const ORIGIN: [f64; 3] = [-10.0, 20.0, 30.0];

/// Stored values, the first axis fastest: a lump of 1500 in air of −1000.
pub fn values() -> Vec<i16> {
    let [width, depth, height] = SIZE;
    let mut values = Vec::new();
    for z in 0..height {
        for y in 0..depth {
            for x in 0..width {
                let is_lump = x >= 2 && (1..6).contains(&y) && z < 5 && x + y + z < 14;
                values.push(if is_lump { 400 + 100 * z as i16 + 10 * x as i16 } else { -1000 });
            }
        }
    }
    values
}

fn bytes(big_endian: bool) -> Vec<u8> {
    values().into_iter().flat_map(|v| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() }).collect()
}

fn joined(head: String, data: Vec<u8>) -> Vec<u8> {
    let mut bytes = head.into_bytes();
    bytes.extend(data);
    bytes
}

/// Every format, with the name of its file.
pub fn samples() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("sform.nii", nifti(false, true)),
        ("qform.nii", nifti(true, false)),
        ("second.nii", nifti_2()),
        ("packed.nii.gz", gzip(&nifti(false, true))),
        ("raw.nrrd", nrrd("raw", "left-posterior-superior", false)),
        ("big.nrrd", nrrd("raw", "LPS", true)),
        ("gz.nrrd", nrrd("gzip", "RAS", false)),
        ("bz.nrrd", nrrd("bzip2", "LPS", false)),
        ("text.nrrd", nrrd("ascii", "right-anterior-superior", false)),
        ("raw.mha", meta(false, false)),
        ("zlib.mha", meta(true, true)),
        ("c.npy", npy(false)),
        ("fortran.npy", npy(true)),
        ("arrays.npz", zip(&[("small.npy", npy(false)[..64].to_vec()), ("large.npy", npy(false))])),
        ("plain.mgh", mgh()),
        ("packed.mgz", gzip(&mgh())),
        ("groups.dcm", dicom::file(dicom::Kind::Groups)),
        ("dose.dcm", dicom::file(dicom::Kind::Dose)),
        ("big.dcm", dicom::file(dicom::Kind::BigEndian)),
        ("packed.dcm", dicom::file(dicom::Kind::RunLengths)),
        ("deflated.dcm", dicom::file(dicom::Kind::Deflated)),
    ]
}

/// NIfTI-1, placed by its rows or by its quaternion; the values of the latter are rescaled.
fn nifti(big_endian: bool, by_rows: bool) -> Vec<u8> {
    let mut header = vec![0u8; 352];
    let mut put = |at: usize, bytes: &[u8]| {
        let mut bytes = bytes.to_vec();
        if big_endian {
            bytes.reverse();
        }
        header[at..at + bytes.len()].copy_from_slice(&bytes);
    };
    put(0, &348u32.to_le_bytes());
    for (n, size) in [3, SIZE[0], SIZE[1], SIZE[2], 1, 1, 1, 1].into_iter().enumerate() {
        put(40 + 2 * n, &(size as i16).to_le_bytes());
    }
    put(70, &4i16.to_le_bytes());
    put(72, &16i16.to_le_bytes());
    put(76, &1f32.to_le_bytes());
    for (n, spacing) in SPACING.into_iter().enumerate() {
        put(80 + 4 * n, &(spacing as f32).to_le_bytes());
    }
    put(108, &352f32.to_le_bytes());
    put(123, &[2]);
    // x and y point to the right and to the front there.
    if by_rows {
        put(254, &1i16.to_le_bytes());
        for (n, sign) in [-1.0, -1.0, 1.0].into_iter().enumerate() {
            put(280 + 20 * n, &((sign * SPACING[n]) as f32).to_le_bytes());
            put(292 + 16 * n, &((sign * ORIGIN[n]) as f32).to_le_bytes());
        }
    } else {
        put(252, &1i16.to_le_bytes());
        // Half a turn around z.
        put(264, &1f32.to_le_bytes());
        for (n, sign) in [-1.0, -1.0, 1.0].into_iter().enumerate() {
            put(268 + 4 * n, &((sign * ORIGIN[n]) as f32).to_le_bytes());
        }
        put(112, &1f32.to_le_bytes());
        put(116, &(-24f32).to_le_bytes());
    }
    header[344..348].copy_from_slice(b"n+1\0");
    let stored = values().into_iter().map(|value| if by_rows { value } else { value + 24 });
    header.extend(stored.flat_map(|v| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() }));
    header
}

fn nifti_2() -> Vec<u8> {
    let mut header = vec![0u8; 544];
    let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, &540u32.to_le_bytes());
    put(4, b"n+2\0\r\n\x1a\n");
    put(12, &4i16.to_le_bytes());
    put(14, &16i16.to_le_bytes());
    for (n, size) in [3, SIZE[0], SIZE[1], SIZE[2], 1, 1, 1, 1].into_iter().enumerate() {
        put(16 + 8 * n, &(size as i64).to_le_bytes());
    }
    put(104, &1f64.to_le_bytes());
    put(168, &544i64.to_le_bytes());
    put(348, &1i32.to_le_bytes());
    for (n, sign) in [-1.0, -1.0, 1.0].into_iter().enumerate() {
        put(112 + 8 * n, &SPACING[n].to_le_bytes());
        put(400 + 40 * n, &(sign * SPACING[n]).to_le_bytes());
        put(424 + 32 * n, &(sign * ORIGIN[n]).to_le_bytes());
    }
    put(500, &2i32.to_le_bytes());
    header.extend(bytes(false));
    header
}

fn nrrd(encoding: &str, space: &str, big_endian: bool) -> Vec<u8> {
    let sign = if space.starts_with('l') || space.starts_with('L') { 1.0 } else { -1.0 };
    let ([a, b, c], [x, y, z]) = (SPACING, ORIGIN);
    let endian = if big_endian { "big" } else { "little" };
    let head = format!(
        "NRRD0004\n# a comment\ntype: int16\ndimension: 3\nspace: {space}\nsizes: {} {} {}\n\
        space directions: ({},0,0) (0,{},0) (0,0,{c})\nkinds: domain domain domain\nendian: {endian}\n\
        encoding: {encoding}\nspace origin: ({},{},{z})\nkey:=value\n\n",
        SIZE[0],
        SIZE[1],
        SIZE[2],
        a * sign,
        b * sign,
        x * sign,
        y * sign
    );
    let data = match encoding {
        "gzip" => gzip(&bytes(false)),
        "bzip2" => bzip2(&bytes(false)),
        "ascii" => values().iter().map(|value| format!("{value}\n")).collect::<String>().into_bytes(),
        _ => bytes(big_endian),
    };
    joined(head, data)
}

fn meta(big_endian: bool, compressed: bool) -> Vec<u8> {
    let ([a, b, c], [x, y, z]) = (SPACING, ORIGIN);
    let head = format!(
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = {big_endian}\n\
        CompressedData = {compressed}\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = {x} {y} {z}\n\
        ElementSpacing = {a} {b} {c}\nDimSize = {} {} {}\nElementType = MET_SHORT\nElementDataFile = LOCAL\n",
        SIZE[0], SIZE[1], SIZE[2]
    );
    joined(head, if compressed { zlib(&bytes(big_endian)) } else { bytes(big_endian) })
}

fn npy(fortran: bool) -> Vec<u8> {
    let [x, y, z] = SIZE;
    let (order, shape) = if fortran { ("True", [x, y, z]) } else { ("False", [z, y, x]) };
    let [a, b, c] = shape;
    let header = format!("{{'descr': '<i2', 'fortran_order': {order}, 'shape': ({a}, {b}, {c}), }}\n");
    let mut head = b"\x93NUMPY\x01\0".to_vec();
    head.extend((header.len() as u16).to_le_bytes());
    head.extend(header.bytes());
    head.extend(bytes(false));
    head
}

/// FreeSurfer's MGH, whose axes point to the right, to the front and to the head.
fn mgh() -> Vec<u8> {
    let mut bytes: Vec<u8> = Vec::new();
    let size = SIZE.map(|size| size as i32);
    // Version, size, frames, kind of numbers (16 bits), degrees of freedom.
    [1, size[0], size[1], size[2], 1, 4, 0].into_iter().for_each(|word: i32| bytes.extend(word.to_be_bytes()));
    bytes.extend(1i16.to_be_bytes());
    let middle: [f64; 3] = std::array::from_fn(|axis| ORIGIN[axis] + SPACING[axis] * SIZE[axis] as f64 / 2.0);
    let reals = [SPACING, [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-middle[0], -middle[1], middle[2]]];
    reals.as_flattened().iter().for_each(|&real| bytes.extend((real as f32).to_be_bytes()));
    bytes.resize(284, 0);
    bytes.extend(self::bytes(true));
    bytes
}
