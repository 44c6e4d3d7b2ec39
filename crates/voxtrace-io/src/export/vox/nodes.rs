//! Instances as a scene graph: one root, one group, and a transform with a shape for each instance and piece of its grid.

use super::{FORMAT, pieces::Piece};
use crate::export::ExportError;
use crate::import::vox::{Body, Dict, GroupNode, MAX_TRANSLATION, ShapeNode, TransformNode, rotation::Rotation};
use std::borrow::Cow;
use voxtrace_scene::scene::{Instance, Keyframe, Scene};
use voxtrace_scene::transform::Transform;

/// The chunks of the scene graph. `pieces[grid]` are the models of a grid, whose ids count through all grids.
pub fn nodes_of(scene: &Scene, pieces: &[Vec<Piece>]) -> Result<Vec<Body<'static>>, ExportError> {
    let first_models: Vec<usize> = pieces
        .iter()
        .scan(0, |models, pieces| {
            *models += pieces.len();
            Some(*models - pieces.len())
        })
        .collect();
    let writer = Writer { scene, pieces, first_models };
    let mut shapes = Vec::new();
    for (index, instance) in scene.instances.iter().enumerate() {
        writer.instance(index, instance, &mut shapes)?;
    }
    let id = |number: usize| {
        i32::try_from(number).map_err(|_| ExportError::TooLarge { format: FORMAT, what: "the instances" })
    };
    let mut children = Vec::with_capacity(shapes.len());
    let mut nodes = Vec::with_capacity(2 * shapes.len());
    for (number, (mut transform, mut shape)) in shapes.into_iter().enumerate() {
        (transform.id, shape.id) = (id(2 + 2 * number)?, id(3 + 2 * number)?);
        transform.child = shape.id;
        children.push(transform.id);
        nodes.extend([Body::Transform(transform), Body::Shape(shape)]);
    }
    let frames = vec![Dict::default()];
    let root = TransformNode { id: 0, attributes: Dict::default(), child: 1, reserved: -1, layer: -1, frames };
    let group = GroupNode { id: 1, attributes: Dict::default(), children };
    nodes.splice(0..0, [Body::Transform(root), Body::Group(group)]);
    Ok(nodes)
}

struct Writer<'s> {
    scene: &'s Scene,
    pieces: &'s [Vec<Piece>],
    /// Id of the first model of each grid.
    first_models: Vec<usize>,
}

impl Writer<'_> {
    /// Appends a transform and a shape for each piece of an instance; their ids are given later.
    fn instance(
        &self,
        index: usize,
        instance: &Instance,
        shapes: &mut Vec<(TransformNode<'static>, ShapeNode<'static>)>,
    ) -> Result<(), ExportError> {
        let still = [Keyframe::still(0, instance.grid, instance.world_from_grid)];
        let keys = if instance.keyframes.is_empty() { &still[..] } else { &instance.keyframes };
        let most_pieces = keys.iter().map(|key| self.pieces[key.grid].len()).max().unwrap_or(0);
        for piece in 0..most_pieces {
            let (mut frames, mut models) = (Vec::new(), Vec::new());
            for (index_of_key, key) in keys.iter().enumerate() {
                // Where this frame's grid has fewer pieces than another's, the last one is shown twice.
                let piece = piece.min(self.pieces[key.grid].len() - 1);
                let mut attributes = Dict::default();
                if !instance.keyframes.is_empty() {
                    attributes.push("_f", key.frame.to_string());
                }
                models.push((self.model(key.grid, piece)?, attributes.clone()));
                let refused = |reason| {
                    let name = instance.name.clone();
                    ExportError::Placement { format: FORMAT, instance: index, name, reason }
                };
                let shown = &self.pieces[key.grid][piece];
                place(&mut attributes, &key.world_from_grid, shown).map_err(refused)?;
                frames.push(attributes);
                let Some(next) = keys.get(index_of_key + 1).filter(|next| next.frame > key.frame + 1) else { continue };
                // Readers move a node evenly to its next key frame: where it goes elsewhere until then, one more says so.
                let next_piece = &self.pieces[next.grid][piece.min(self.pieces[next.grid].len() - 1)];
                let goes_on = place_of(&key.end, shown).map_err(refused)?.1
                    == place_of(&next.world_from_grid, next_piece).map_err(refused)?.1;
                if !goes_on {
                    let share = (next.frame - 1 - key.frame) as f32 / (next.frame - key.frame) as f32;
                    let translation = key.world_from_grid.translation.lerp(key.end.translation, share).round();
                    let mut attributes = Dict::default();
                    attributes.push("_f", (next.frame - 1).to_string());
                    models.push((self.model(key.grid, piece)?, attributes.clone()));
                    place(&mut attributes, &Transform { translation, ..key.world_from_grid }, shown)
                        .map_err(refused)?;
                    frames.push(attributes);
                }
            }
            let attributes = attributes_of(instance);
            // Where there are no layers, everything is in MagicaVoxel's first one.
            let no_layer = if self.scene.layers.is_empty() { 0 } else { -1 };
            let layer = instance.layer.and_then(|layer| i32::try_from(layer).ok()).unwrap_or(no_layer);
            let transform = TransformNode { id: 0, attributes, child: 0, reserved: -1, layer, frames };
            let mut attributes = Dict::default();
            if loops(instance) {
                attributes.push("_loop", "1");
            }
            shapes.push((transform, ShapeNode { id: 0, attributes, models }));
        }
        Ok(())
    }

    fn model(&self, grid: usize, piece: usize) -> Result<i32, ExportError> {
        i32::try_from(self.first_models[grid] + piece)
            .map_err(|_| ExportError::TooLarge { format: FORMAT, what: "the models" })
    }
}

fn attributes_of(instance: &Instance) -> Dict<'static> {
    let mut attributes = Dict::default();
    if !instance.name.is_empty() {
        attributes.0.push((Cow::Borrowed(b"_name"), Cow::Owned(instance.name.clone().into_bytes())));
    }
    if instance.hidden {
        attributes.push("_hidden", "1");
    }
    if loops(instance) {
        attributes.push("_loop", "1");
    }
    attributes
}

/// Whether all of an instance's key frames come again: what begins with frames that do not is written once.
fn loops(instance: &Instance) -> bool {
    let keys = &instance.keyframes;
    let all = keys.first().zip(keys.last()).map(|(first, last)| first.frame..last.frame.saturating_add(1));
    all.is_some() && instance.repeats == all
}

/// Says where a piece stands.
fn place(attributes: &mut Dict, world_from_grid: &Transform, piece: &Piece) -> Result<(), &'static str> {
    let (rotation, [x, y, z]) = place_of(world_from_grid, piece)?;
    if rotation != Rotation::IDENTITY {
        attributes.push("_r", rotation.to_byte().to_string());
    }
    attributes.push("_t", format!("{x} {y} {z}"));
    Ok(())
}

/// Rotation and translation of a piece: its voxel ⌊size / 2⌋ has its lower corner at the translation before it is turned.
fn place_of(world_from_grid: &Transform, piece: &Piece) -> Result<(Rotation, [i64; 3]), &'static str> {
    let rotation =
        Rotation::from_matrix(&world_from_grid.linear).ok_or("has only quarter turns and mirrors, at scale 1")?;
    let corner = world_from_grid.translation.to_array();
    if corner.iter().any(|coordinate| coordinate.fract() != 0.0 || coordinate.abs() > MAX_TRANSLATION as f32) {
        return Err("places instances at whole voxels up to 2²³ only");
    }
    let pivot = [0, 1, 2].map(|axis| i64::from(piece.offset[axis]) + i64::from(piece.size[axis] / 2));
    let turned = rotation.apply(pivot);
    Ok((rotation, [0, 1, 2].map(|axis| corner[axis] as i64 + turned[axis])))
}
