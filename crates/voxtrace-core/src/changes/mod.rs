//! What somebody changes about a scene that was read: materials, which parts are seen, the sun. As text, these are the values of
//! `--material`, `--hide`, `--show` and `--sun` of `voxtrace render`; a window makes the same text of what was changed in it.

mod material;
mod part;
mod sun;

pub use material::MaterialChange;
pub use part::{PartName, visible_parts};
pub use sun::SunSetting;

use crate::packed::{Outline, PackedMaterial, PackedScene};
use std::str::FromStr;
use voxtrace_scene::Scene;

/// A change that cannot be made, or a text that is none.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChangeError {
    /// The text does not say a material's colour.
    #[error("{0:?} is not NUMBER=COLOR[,EMISSION], like 3=#ff8800 or 3=1,0.2,0,5")]
    NoMaterial(String),
    /// A channel is out of its range.
    #[error("{0}: a colour's channels are from 0 to 1, an emission's are not below 0")]
    OutOfRange(String),
    /// There is no material of this number.
    #[error("there is no material {number}: {}", numbered(*count, "material"))]
    MissingMaterial {
        /// The number.
        number: usize,
        /// Materials there are.
        count: usize,
    },
    /// No layer, group or object has this name or number.
    #[error("the scene has no part {name:?}: {has}")]
    MissingPart {
        /// As it was asked for.
        name: String,
        /// What there is, for people.
        has: String,
    },
    /// What is hidden in voxtrace's own files is not in them.
    #[error("a .vxt file holds what was seen when it was written, and {0:?} was not")]
    NotKept(String),
}

/// "it has 4 materials, numbered from 0".
fn numbered(count: usize, noun: &str) -> String {
    match count {
        0 => format!("it has no {noun}s"),
        1 => format!("it has one {noun}, number 0"),
        _ => format!("it has {count} {noun}s, numbers 0 to {}", count - 1),
    }
}

/// Changes to a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneChanges {
    /// Materials; of one number the last one counts.
    pub materials: Vec<MaterialChange>,
    /// Parts that are not seen.
    pub hidden: Vec<PartName>,
}

impl SceneChanges {
    /// Whether nothing changes.
    pub fn is_empty(&self) -> bool {
        self.materials.is_empty() && self.hidden.is_empty()
    }

    /// The scene with the changes: as packing a scene with these materials, its grids all the same. What is large is shared.
    ///
    /// # Errors
    /// [`ChangeError`] where there is no such material or part.
    pub fn apply(&self, scene: &PackedScene) -> Result<PackedScene, ChangeError> {
        let mut changed = scene.clone();
        if !self.materials.is_empty() {
            let mut materials: Vec<PackedMaterial> = scene.materials().to_vec();
            for change in &self.materials {
                change.apply(&mut materials)?;
            }
            changed = changed.with_materials(materials);
        }
        if !self.hidden.is_empty() {
            let outline = &scene.outline;
            let mut is_hidden = vec![false; outline.objects.len()];
            for part in &self.hidden {
                part.objects(outline)?.into_iter().for_each(|object| is_hidden[object] = true);
            }
            // What is merged cannot be left out in part.
            changed =
                changed.split().without(|instance| is_hidden.get(instance.scene_instance as usize) == Some(&true));
        }
        Ok(changed)
    }
}

/// Makes parts of a scene visible that its file hides, before it is packed. What holds them, a hidden layer say, hides them no more, and
/// goes on hiding the rest.
///
/// # Errors
/// [`ChangeError::MissingPart`] where there is no such part.
pub fn show_parts(scene: &mut Scene, shown: &[PartName]) -> Result<(), ChangeError> {
    if shown.is_empty() {
        return Ok(());
    }
    let outline = Outline::of_scene(scene);
    let mut is_hidden: Vec<bool> = outline.objects.iter().map(|object| object.is_hidden).collect();
    for part in shown {
        part.objects(&outline)?.into_iter().for_each(|object| is_hidden[object] = false);
    }
    scene.layers.iter_mut().for_each(|layer| layer.hidden = false);
    scene.instances.iter_mut().zip(is_hidden).for_each(|(instance, is_hidden)| instance.hidden = is_hidden);
    Ok(())
}

/// A number from text that is finite.
fn finite(text: &str) -> Option<f32> {
    f32::from_str(text.trim()).ok().filter(|value| value.is_finite())
}

#[cfg(test)]
mod tests;
