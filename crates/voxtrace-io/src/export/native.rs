//! What a scene file of voxtrace (`.vxt`), which holds what tracers read, leaves out of a scene.

use super::vox;
use voxtrace_scene::scene::Scene;

/// What of a scene is not in a `.vxt` file, one phrase each: hidden instances, movement, names, and what the file that the
/// scene came from says beyond a scene.
pub fn left_out(scene: &Scene) -> Vec<String> {
    let instances = || scene.instances.iter();
    let counts = [
        ("hidden instances", instances().filter(|instance| !scene.is_visible(instance)).count()),
        ("moving instances", instances().filter(|instance| instance.keyframes.len() > 1).count()),
        ("names of instances", instances().filter(|instance| !instance.name.is_empty()).count()),
        ("names of layers", scene.layers.iter().filter(|layer| !layer.name.is_empty()).count()),
    ];
    let counted = counts.into_iter().filter(|&(_, count)| count > 0).map(|(what, count)| format!("{what} ({count})"));
    counted.chain(vox::beyond_scenes(scene)).collect()
}
