//! Blocks of Minecraft on the command line: of how many voxels they are, and whose pictures they have.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use voxtrace::import::{BlockOptions, BlockSize};

/// Options about blocks of Minecraft.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Minecraft")]
pub struct BlockArgs {
    /// Voxels along an edge of a block: 1 makes all blocks cubes, from 2 on they have their shapes, at 16 all of them
    #[arg(long, value_name = "N", value_parser = sizes(), default_value = "1")]
    block_size: BlockSize,
    /// Resource pack whose pictures colour the blocks (Java edition, a folder or a ZIP file)
    #[arg(long, value_name = "FILE|FOLDER")]
    resource_pack: Option<PathBuf>,
}

fn sizes() -> impl TypedValueParser<Value = BlockSize> {
    PossibleValuesParser::new(["1", "2", "4", "8", "16"]).map(|text| {
        let size = BlockSize::ALL.into_iter().find(|size| size.edge().to_string() == text);
        size.unwrap_or_default()
    })
}

impl BlockArgs {
    /// Whether blocks are more than cubes.
    pub fn have_shapes(&self) -> bool {
        self.block_size > BlockSize::One
    }

    /// Options that are given, which are for blocks alone.
    pub fn asked(&self) -> impl Iterator<Item = &'static str> {
        let asked = [("--block-size", self.have_shapes()), ("--resource-pack", self.resource_pack.is_some())];
        asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option))
    }

    /// How blocks become voxels; `shell` drops what nobody sees of them.
    pub fn options(&self, shell: bool) -> BlockOptions {
        BlockOptions { size: self.block_size, resource_pack: self.resource_pack.clone(), shell }
    }
}
