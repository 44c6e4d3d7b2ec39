//! Options that change a scene once it is read: materials, and which of its parts are seen.

use crate::failure::Failure;
use crate::load::{MemoryArgs, into_packed};
use voxtrace::PackedScene;
use voxtrace::changes::{ChangeError, MaterialChange, PartName, SceneChanges, show_parts};
use voxtrace::import::Content;

/// Options about materials and parts.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Changes")]
pub struct ChangeArgs {
    /// Another colour for a material, by its number: #rrggbb or linear r,g,b; EMISSION is a factor on the colour or linear r,g,b
    #[arg(long, value_name = "N=COLOR[,EMISSION]")]
    material: Vec<MaterialChange>,
    /// Leave out a part: a name, an object's number, or layer:, group: or object: with a name or number
    #[arg(long, value_name = "PART")]
    hide: Vec<PartName>,
    /// Show a part that the file hides
    #[arg(long, value_name = "PART")]
    show: Vec<PartName>,
}

impl ChangeArgs {
    /// Parts that are left out.
    pub fn hidden(&self) -> &[PartName] {
        &self.hide
    }

    /// Parts that the file hides and that are seen.
    pub fn shown(&self) -> &[PartName] {
        &self.show
    }

    /// The packed scene with the changes. What is hidden in part is kept apart.
    pub fn packed(&self, content: Content, memory: MemoryArgs) -> Result<PackedScene, Failure> {
        let packed = packed_with(content, &self.show, memory.keeping_instances(!self.hide.is_empty()))?;
        let changes = SceneChanges { materials: self.material.clone(), hidden: self.hide.clone() };
        if changes.is_empty() { Ok(packed) } else { changes.apply(&packed).map_err(change_failure) }
    }
}

/// Packs a scene, with parts that its file hides.
pub fn packed_with(mut content: Content, shown: &[PartName], memory: MemoryArgs) -> Result<PackedScene, Failure> {
    match &mut content {
        Content::Scene(scene) => show_parts(scene, shown).map_err(change_failure)?,
        Content::Packed(packed) => {
            for part in shown {
                let objects = part.objects(&packed.outline).map_err(change_failure)?;
                if objects.iter().any(|&object| packed.outline.objects[object].is_hidden) {
                    return Err(change_failure(ChangeError::NotKept(part.to_string())));
                }
            }
        }
    }
    into_packed(content, memory)
}

fn change_failure(error: ChangeError) -> Failure {
    Failure::usage(error).hint("`voxtrace info` lists layers, groups and objects, `voxtrace view` materials too")
}
