//! The bits of a scan, the highest first. Behind a byte of ones only seven bits of the next one count (T.87, A.1).

/// Zeros that are supplied behind the end: the last code may be cut where its rest is 0.
const GRACE: u32 = 64;

pub(super) struct Bits<'a> {
    bytes: std::slice::Iter<'a, u8>,
    /// Bits that are waiting, the lowest `count`.
    waiting: u64,
    count: u32,
    is_stuffed: bool,
    supplied: u32,
}

impl<'a> Bits<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes: bytes.iter(), waiting: 0, count: 0, is_stuffed: false, supplied: 0 }
    }

    /// So many bits, at most 32.
    pub fn take(&mut self, count: u32) -> Result<u32, String> {
        while self.count < count {
            self.fill()?;
        }
        self.count -= count;
        Ok((self.waiting >> self.count & ((1 << count) - 1)) as u32)
    }

    /// The number of zeros before the next one, which is taken too; more than `most` are an error.
    pub fn zeros(&mut self, most: u32) -> Result<u32, String> {
        let mut zeros = 0;
        loop {
            if self.count == 0 {
                self.fill()?;
            }
            let left = (self.waiting << (64 - self.count)).leading_zeros().min(self.count);
            zeros += left;
            if zeros > most {
                return Err("a code that is too long".into());
            }
            self.count -= left;
            if self.count > 0 {
                self.count -= 1;
                return Ok(zeros);
            }
        }
    }

    fn fill(&mut self) -> Result<(), String> {
        let byte = match self.bytes.next() {
            Some(&byte) => byte,
            None if self.supplied < GRACE => {
                self.supplied += 8;
                0
            }
            None => return Err("the samples end too early".into()),
        };
        let bits = if self.is_stuffed { 7 } else { 8 };
        self.waiting = self.waiting << bits | u64::from(byte);
        self.count += bits;
        self.is_stuffed = byte == 0xff;
        Ok(())
    }
}
