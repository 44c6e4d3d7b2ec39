//! Samples as files have them: numbers of 8 or 16 bits stay codes, whose real values stand in a table; all others are real.

/// Some samples of a layer, row after row.
#[derive(Clone, Debug)]
pub enum Block {
    /// Codes of [`Coding::Bytes`].
    Bytes(Vec<u8>),
    /// Codes of [`Coding::Words`].
    Words(Vec<u16>),
    /// Real values.
    Reals(Vec<f32>),
}

/// What the samples of a source are. Codes of signed numbers count from the least one on, so that the order of codes is that of numbers.
#[derive(Clone, Debug)]
pub enum Coding {
    /// Codes of 8 bits, with the real value of each of the 256.
    Bytes(Vec<f32>),
    /// Codes of 16 bits, with the real value of each of the 65,536.
    Words(Vec<f32>),
    /// Real values.
    Reals,
}

impl Coding {
    /// A block of that kind, without samples.
    pub fn block(&self) -> Block {
        match self {
            Self::Bytes(_) => Block::Bytes(Vec::new()),
            Self::Words(_) => Block::Words(Vec::new()),
            Self::Reals => Block::Reals(Vec::new()),
        }
    }

    /// Bytes of a sample in a block.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Bytes(_) => 1,
            Self::Words(_) => 2,
            Self::Reals => 4,
        }
    }

    /// The real values of all codes; empty where there are none.
    pub fn table(&self) -> &[f32] {
        match self {
            Self::Bytes(table) | Self::Words(table) => table,
            Self::Reals => &[],
        }
    }
}

impl Block {
    /// Number of samples.
    pub fn len(&self) -> usize {
        match self {
            Self::Bytes(codes) => codes.len(),
            Self::Words(codes) => codes.len(),
            Self::Reals(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Makes room for so many samples, or forgets those behind them.
    pub fn resize(&mut self, count: usize) {
        match self {
            Self::Bytes(codes) => codes.resize(count, 0),
            Self::Words(codes) => codes.resize(count, 0),
            Self::Reals(values) => values.resize(count, 0.0),
        }
    }
}
