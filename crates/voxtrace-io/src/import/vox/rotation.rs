//! The 48 ways to turn and mirror a voxel grid onto itself, and the byte that a .vox file gives for each: bits 0–1 and
//! 2–3 name the column of the entry ±1 in the first and second row of the matrix, bits 4–6 the signs of the three rows.

use glam::Mat3;
use std::ops::Neg;

/// A signed permutation matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rotation {
    /// Column of the entry that is not 0, for each row.
    column: [usize; 3],
    /// Whether that entry is −1, for each row.
    negative: [bool; 3],
}

impl Rotation {
    /// The matrix that changes nothing.
    pub const IDENTITY: Self = Self { column: [0, 1, 2], negative: [false; 3] };

    /// The matrix of a `_r` byte, `None` where the byte names no rotation.
    pub fn from_byte(byte: u8) -> Option<Self> {
        let (first, second) = (usize::from(byte & 3), usize::from(byte >> 2 & 3));
        if first == 3 || second == 3 || first == second || byte >> 7 != 0 {
            return None;
        }
        let negative = [4, 5, 6].map(|bit| byte >> bit & 1 != 0);
        Some(Self { column: [first, second, 3 - first - second], negative })
    }

    /// The `_r` byte.
    pub fn to_byte(self) -> u8 {
        let signs = (0..3).map(|row| u8::from(self.negative[row]) << (4 + row)).sum::<u8>();
        self.column[0] as u8 | (self.column[1] as u8) << 2 | signs
    }

    /// The rotation that a matrix is, `None` where it has an entry other than 0, 1 and −1 or is no rotation.
    pub fn from_matrix(matrix: &Mat3) -> Option<Self> {
        let (mut column, mut negative) = ([0; 3], [false; 3]);
        for row in 0..3 {
            let entries = matrix.row(row).to_array();
            let found = entries.iter().position(|&entry| entry != 0.0)?;
            let others_are_zero = entries.iter().filter(|&&entry| entry != 0.0).count() == 1;
            if !others_are_zero || entries[found].abs() != 1.0 {
                return None;
            }
            (column[row], negative[row]) = (found, entries[found] < 0.0);
        }
        let all_columns = (0..3).all(|axis| column.contains(&axis));
        all_columns.then_some(Self { column, negative })
    }

    /// The matrix.
    pub fn to_matrix(self) -> Mat3 {
        let mut columns = [[0.0; 3]; 3];
        for row in 0..3 {
            columns[self.column[row]][row] = if self.negative[row] { -1.0 } else { 1.0 };
        }
        Mat3::from_cols_array_2d(&columns)
    }

    /// Image of a vector.
    pub fn apply<N: Copy + Neg<Output = N>>(self, vector: [N; 3]) -> [N; 3] {
        [0, 1, 2].map(|row| if self.negative[row] { -vector[self.column[row]] } else { vector[self.column[row]] })
    }

    /// `self` after `first`.
    pub fn after(self, first: Self) -> Self {
        Self {
            column: self.column.map(|column| first.column[column]),
            negative: [0, 1, 2].map(|row| self.negative[row] ^ first.negative[self.column[row]]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<(u8, Rotation)> {
        (0..=255).filter_map(|byte| Some((byte, Rotation::from_byte(byte)?))).collect()
    }

    #[test]
    fn there_are_48_rotations_and_each_keeps_its_byte() {
        let rotations = all();
        assert_eq!(rotations.len(), 48);
        for (byte, rotation) in rotations {
            assert_eq!(rotation.to_byte(), byte);
            assert_eq!(Rotation::from_matrix(&rotation.to_matrix()), Some(rotation));
        }
    }

    #[test]
    fn the_byte_of_the_format_text_gives_its_matrix() {
        let rotation = Rotation::from_byte(1 | 2 << 2 | 1 << 5 | 1 << 6).unwrap();
        let rows = Mat3::from_cols_array_2d(&[[0., 1., 0.], [0., 0., -1.], [-1., 0., 0.]]).transpose();
        assert_eq!(rotation.to_matrix(), rows);
        assert_eq!(rotation.apply([1, 2, 3]), [2, -3, -1]);
    }

    #[test]
    fn composing_rotations_multiplies_their_matrices() {
        for (_, a) in all() {
            for (_, b) in all() {
                assert_eq!(a.after(b).to_matrix(), a.to_matrix() * b.to_matrix());
                assert_eq!(a.after(b).apply([1, 2, 3]), a.apply(b.apply([1, 2, 3])));
            }
        }
    }

    #[test]
    fn a_matrix_that_is_no_rotation_is_refused() {
        for columns in
            [[[2., 0., 0.], [0., 1., 0.], [0., 0., 1.]], [[1., 0., 0.], [1., 0., 0.], [0., 0., 1.]], [[0.; 3]; 3]]
        {
            assert_eq!(Rotation::from_matrix(&Mat3::from_cols_array_2d(&columns)), None);
        }
    }
}
