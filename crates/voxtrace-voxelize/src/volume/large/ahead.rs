//! A thread of its own reads layers one step ahead of the work on them, so that neither waits for the other. Blocks go back and forth.

use super::{Block, SampleSource};
use crate::import_error::ImportError;
use crate::voxelize::VoxelizeError;
use std::io;
use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, Sender, channel, sync_channel};
use std::thread;

/// Blocks on the way: one that is read, one that waits, one that is free.
pub(super) const ON_THE_WAY: u64 = 3;

/// Layers in the order in which they are read.
pub(super) struct Ahead {
    filled: Receiver<Result<(usize, Block), ImportError>>,
    free: Sender<Block>,
}

impl Ahead {
    /// The next layer, with its number.
    pub fn next(&self) -> Result<(usize, Block), VoxelizeError> {
        match self.filled.recv() {
            Ok(read) => Ok(read?),
            Err(_) => Err(VoxelizeError::Io(io::ErrorKind::UnexpectedEof.into())),
        }
    }

    /// Gives a block back, to be filled again.
    pub fn give_back(&self, block: Block) {
        // Nobody wants it after the last layer.
        let _ = self.free.send(block);
    }
}

/// Works on some rows of the layers that are named, in that order; reading ends with the work.
pub(super) fn ahead<R>(
    source: &mut dyn SampleSource,
    layers: Vec<usize>,
    rows: Range<usize>,
    work: impl FnOnce(Ahead) -> Result<R, VoxelizeError>,
) -> Result<R, VoxelizeError> {
    let (give, filled) = sync_channel(1);
    let (free, emptied) = channel::<Block>();
    let kind = source.coding().block();
    let count = rows.len() * source.frame().size[0];
    let read = move || {
        for layer in layers {
            let mut block = emptied.try_recv().unwrap_or_else(|_| kind.clone());
            block.resize(count);
            let read = source.read(layer, rows.clone(), &mut block).map(|()| (layer, block));
            let is_last = read.is_err();
            if give.send(read).is_err() || is_last {
                return;
            }
        }
    };
    thread::scope(|scope| {
        let reader = thread::Builder::new().name("samples".into()).spawn_scoped(scope, read)?;
        let done = work(Ahead { filled, free });
        match reader.join() {
            Ok(()) => done,
            Err(panic) => resume_unwind(panic),
        }
    })
}
