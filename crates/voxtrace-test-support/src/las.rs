//! A small tile of a scan.

/// A LAS file of points a metre apart, 8 by 8, from a place on; each row has a class of its own, 1 to 8.
pub fn las_tile([x, y]: [i32; 2]) -> Vec<u8> {
    let mut bytes = vec![0; 227];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &227u16.to_le_bytes());
    put(96, &227u32.to_le_bytes());
    put(105, &20u16.to_le_bytes());
    put(107, &64u32.to_le_bytes());
    (0..3).for_each(|axis| put(131 + 8 * axis, &1f64.to_le_bytes()));
    for (axis, low) in [f64::from(x), f64::from(y), 0.0].into_iter().enumerate() {
        put(179 + 16 * axis, &[low + if axis < 2 { 7.0 } else { 0.0 }, low].map(f64::to_le_bytes).concat());
    }
    for at in 0..64 {
        let mut record = [0; 20];
        record[..8].copy_from_slice([x + at % 8, y + at / 8].map(i32::to_le_bytes).as_flattened());
        record[15] = 1 + (at / 8) as u8;
        bytes.extend(record);
    }
    bytes
}
