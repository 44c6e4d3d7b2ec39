//! What the parts of a packed scene are called and how they belong together: objects, which are the instances of the scene that was
//! packed, and the layers and groups that hold them. No tracer needs it; people do, to say which part they mean.

use super::PackedInstance;
use voxtrace_scene::scene::{Group, Scene};

/// The parts of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// Instances of the scene, hidden ones too: [`PackedInstance::scene_instance`] is an index.
    pub objects: Vec<Object>,
    /// Names of the layers, empty where there is none.
    pub layers: Vec<String>,
    /// Groups.
    pub groups: Vec<Group>,
}

/// An instance of the scene that was packed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Object {
    /// Name, empty where there is none.
    pub name: String,
    /// Index into [`Outline::layers`].
    pub layer: Option<usize>,
    /// Index into [`Outline::groups`] of the innermost group that holds it.
    pub group: Option<usize>,
    /// Whether it was hidden when the scene was packed, and so is not in it.
    pub is_hidden: bool,
}

impl Outline {
    /// The parts of a scene.
    pub fn of_scene(scene: &Scene) -> Self {
        let object = |instance: &voxtrace_scene::Instance| Object {
            name: instance.name.clone(),
            layer: instance.layer.filter(|&layer| layer < scene.layers.len()),
            group: instance.group.filter(|&group| group < scene.groups.len()),
            is_hidden: !scene.is_visible(instance),
        };
        Self {
            objects: scene.instances.iter().map(object).collect(),
            layers: scene.layers.iter().map(|layer| layer.name.clone()).collect(),
            groups: scene.groups.clone(),
        }
    }

    /// The parts of a scene whose file keeps no names: those of its instances that there are.
    pub(crate) fn of_instances(instances: &[PackedInstance]) -> Self {
        // Numbers of a file may be anything; those far beyond the instances that there are have no entry.
        let most = (instances.len() as u64 * 64).max(1 << 16);
        let numbers =
            instances.iter().map(|instance| u64::from(instance.scene_instance)).filter(|&number| number < most);
        let mut objects =
            vec![Object { is_hidden: true, ..Object::default() }; numbers.max().map_or(0, |most| most as usize + 1)];
        for instance in instances {
            if let Some(object) = objects.get_mut(instance.scene_instance as usize) {
                object.is_hidden = false;
            }
        }
        Self { objects, ..Self::default() }
    }

    /// Whether an object is in a group, or in a group within it.
    pub fn is_in_group(&self, object: &Object, group: usize) -> bool {
        let mut around = object.group;
        while let Some(index) = around {
            if index == group {
                return true;
            }
            // A parent comes before its groups: no circle.
            around = self.groups.get(index).and_then(|found| found.parent).filter(|&parent| parent < index);
        }
        false
    }
}
