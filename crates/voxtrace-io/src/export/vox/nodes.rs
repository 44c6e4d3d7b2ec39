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
        let still = [Keyframe { frame: 0, grid: instance.grid, world_from_grid: instance.world_from_grid }];
        let keys = if instance.keyframes.is_empty() { &still[..] } else { &instance.keyframes };
        let most_pieces = keys.iter().map(|key| self.pieces[key.grid].len()).max().unwrap_or(0);
        for piece in 0..most_pieces {
            let (mut frames, mut models) = (Vec::new(), Vec::new());
            for key in keys {
                // Where this frame's grid has fewer pieces than another's, the last one is shown twice.
                let piece = piece.min(self.pieces[key.grid].len() - 1);
                let mut attributes = Dict::default();
                if !instance.keyframes.is_empty() {
                    attributes.push("_f", key.frame.to_string());
                }
                models.push((self.model(key.grid, piece)?, attributes.clone()));
                let placed = place(&mut attributes, &key.world_from_grid, &self.pieces[key.grid][piece]);
                let name = || instance.name.clone();
                placed.map_err(|reason| ExportError::Placement {
                    format: FORMAT,
                    instance: index,
                    name: name(),
                    reason,
                })?;
                frames.push(attributes);
            }
            let attributes = attributes_of(instance);
            // Where there are no layers, everything is in MagicaVoxel's first one.
            let no_layer = if self.scene.layers.is_empty() { 0 } else { -1 };
            let layer = instance.layer.and_then(|layer| i32::try_from(layer).ok()).unwrap_or(no_layer);
            let transform = TransformNode { id: 0, attributes, child: 0, reserved: -1, layer, frames };
            shapes.push((transform, ShapeNode { id: 0, attributes: Dict::default(), models }));
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
    attributes
}

/// Says where a piece stands: its voxel ⌊size / 2⌋ has its lower corner at the translation before it is turned.
fn place(attributes: &mut Dict, world_from_grid: &Transform, piece: &Piece) -> Result<(), &'static str> {
    let rotation =
        Rotation::from_matrix(&world_from_grid.linear).ok_or("has only quarter turns and mirrors, at scale 1")?;
    let corner = world_from_grid.translation.to_array();
    if corner.iter().any(|coordinate| coordinate.fract() != 0.0 || coordinate.abs() > MAX_TRANSLATION as f32) {
        return Err("places instances at whole voxels up to 2²³ only");
    }
    let pivot = [0, 1, 2].map(|axis| i64::from(piece.offset[axis]) + i64::from(piece.size[axis] / 2));
    let turned = rotation.apply(pivot);
    let [x, y, z] = [0, 1, 2].map(|axis| corner[axis] as i64 + turned[axis]);
    if rotation != Rotation::IDENTITY {
        attributes.push("_r", rotation.to_byte().to_string());
    }
    attributes.push("_t", format!("{x} {y} {z}"));
    Ok(())
}
