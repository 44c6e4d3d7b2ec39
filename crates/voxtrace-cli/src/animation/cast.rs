//! A scene that is about to move: its objects and what they do, and the scene that is packed, in which everything is that is ever seen.

use super::{DEFAULT_FPS, DEFAULT_KEY_FPS, Director, objects};
use crate::failure::Failure;
use crate::views::ViewArgs;
use voxtrace::animation::{Animation, Curve, NodeMotion, Playback, keyframe_count, playing};
use voxtrace::changes::{PartName, show_parts};
use voxtrace::import::Content;
use voxtrace::packed::Outline;
use voxtrace::{Instance, Scene};

/// Times at which things are looked for, to know how far they go.
const LOOKS: u32 = 24;

/// The scene and its animation, without its camera.
pub struct Cast {
    pub base: Scene,
    pub outline: Outline,
    pub animation: Animation,
    pub fps: f64,
    /// Share of a frame's time in which the shutter is open.
    pub shutter: f64,
    /// Frames of the whole.
    pub total: u32,
    /// Whether the animation's file says how many, and nothing comes after them.
    pub is_ended: bool,
    /// Whether objects move, and not the camera alone.
    pub is_moving: bool,
}

impl Director {
    /// Looks up what moves in a scene. The content that comes back is to be packed, with instances apart where objects move.
    pub fn cast(&self, content: Content, view: &ViewArgs, shown: &[PartName]) -> Result<(Content, Cast), Failure> {
        let (base, untouched) = self.base_of(content, shown)?;
        let outline = Outline::of_scene(&base);
        let keyframes = keyframe_count(&base);
        let clip = self.clip_of(&base)?;
        let script = self.script.as_ref();
        let is_alone =
            script.is_none() && keyframes > 0 && clip.is_none() && view.turntable.is_none() && view.flight.is_none();
        let usual = if is_alone { DEFAULT_KEY_FPS } else { DEFAULT_FPS };
        let fps = self.args.fps.or(script.and_then(|script| script.fps)).unwrap_or(usual);
        let keyframe_rate = self.args.key_fps.or(script.and_then(|script| script.key_fps)).unwrap_or(fps);
        let mut animation = Animation { keyframe_rate, ..Animation::default() };
        animation.clip = match script.is_some_and(|script| script.animation_repeats) {
            true => Playback::Repeated,
            false => Playback::Once,
        };
        let mut has_camera = view.turntable.is_some() || view.flight.is_some();
        let clip_seconds = clip.map(|(seconds, _)| seconds);
        let clip_has_camera = clip.is_some_and(|(_, motion)| !motion.cameras.is_empty());
        if let Some(script) = script {
            script.with_table(|table| {
                for object in table.tables("object")? {
                    animation.objects.extend(objects::tracks(&object, &base, &outline)?);
                }
                has_camera |= table.has("camera");
                animation.sun = curve(&table, "sun", ["bearing", "height", "strength"], [0.0, 45.0, 3.0])?;
                animation.sky_brightness = curve(&table, "sky", ["brightness"], [1.0])?;
                Ok(())
            })?;
        }
        let is_moving = animation.moves_objects(&base);
        let has_light = animation.sun.is_some() || animation.sky_brightness.is_some();
        if !(is_moving || has_camera || has_light || clip_has_camera) {
            let failure = Failure::usage(format!("nothing moves in {}", base.name));
            return Err(failure.hint(
                "--turntable or --flight TOML move the camera, and docs/animation.md says how a TOML moves objects",
            ));
        }
        let frames_of = |seconds: f64| (seconds * fps).round().clamp(1.0, 1e6) as u32;
        let of_keys = (keyframes > 0).then(|| frames_of(f64::from(keyframes) / keyframe_rate));
        let of_keys = of_keys.max(clip_seconds.map(frames_of));
        let of_range = view.frames.as_ref().map(|frames| *frames.end());
        let total = self.total(view, fps).or(if has_camera { of_range.or(of_keys) } else { of_keys.or(of_range) });
        let Some(total) = total.or((has_camera && script.is_none()).then_some(120)) else {
            return Err(Failure::usage("nobody says how long the clip lasts")
                .hint("`seconds` or `frames` in the TOML do, or --frames A..B"));
        };
        let shutter = self.args.shutter.map(f64::from).or(script.and_then(|script| script.shutter)).unwrap_or(0.0);
        let is_ended = script.is_some_and(|script| script.frames.is_some() || script.seconds.is_some());
        let cast = Cast { base, outline, animation, fps, shutter, total, is_ended, is_moving };
        let content = match untouched {
            Some(content) if !is_moving => content,
            _ => Content::Scene(cast.all_at_once().into()),
        };
        Ok((content, cast))
    }

    /// How long the clip lasts that the scene brings along, in seconds, and what moves in it; faults where another one was asked for.
    fn clip_of<'s>(&self, scene: &'s Scene) -> Result<Option<(f64, &'s NodeMotion)>, Failure> {
        let playing = playing(scene);
        match self.clip() {
            Some(name) if playing.is_none() => {
                let known = scene.clips.iter().enumerate();
                let known: Vec<String> = known.map(|(index, clip)| format!("{} {:?}", index + 1, clip.name)).collect();
                let is_there = scene.clips.iter().any(|clip| clip.name == name);
                let what = if is_there { "nothing moves in the animation" } else { "there is no animation" };
                let failure = Failure::usage(format!("{what} {name:?} of {}", scene.name));
                Err(match known.is_empty() {
                    true => failure.hint("files of glTF bring animations along, and this one has none"),
                    false => failure.hint(format!("it has {}", known.join(", "))),
                })
            }
            _ => Ok(playing),
        }
    }

    /// The scene as it can be changed, and the content as it was where that is to be packed if nothing moves. A packed scene is only taken
    /// apart where the animation names parts of it.
    fn base_of(&self, content: Content, shown: &[PartName]) -> Result<(Scene, Option<Content>), Failure> {
        let failed = |error| Failure::usage(error).hint("`voxtrace info` lists layers, groups and objects");
        match content {
            Content::Scene(mut scene) => {
                show_parts(&mut scene, shown).map_err(failed)?;
                let mut base = (*scene).clone();
                // What a layer hides can be made visible alone.
                let hidden: Vec<bool> = base.instances.iter().map(|instance| !base.is_visible(instance)).collect();
                base.instances.iter_mut().zip(hidden).for_each(|(instance, hidden)| instance.hidden = hidden);
                base.layers.iter_mut().for_each(|layer| layer.hidden = false);
                Ok((base, Some(Content::Scene(scene))))
            }
            Content::Packed(packed) => {
                let names_parts = |script: &super::Script| {
                    script.with_table(|table| {
                        let camera = table.table("camera")?;
                        Ok(table.has("object") || camera.is_some_and(|camera| camera.is_text("look_at")))
                    })
                };
                if !self.script.as_ref().map(names_parts).transpose()?.unwrap_or(false) {
                    let cameras = packed.cameras.clone();
                    let base = Scene { cameras, ..Scene::new(packed.name.clone()) };
                    return Ok((base, Some(Content::Packed(packed))));
                }
                let mut scene = packed.to_scene();
                let names = packed.split();
                for (instance, kept) in scene.instances.iter_mut().zip(names.instances()) {
                    let object = names.outline.objects.get(kept.scene_instance as usize);
                    instance.name = object.map_or_else(String::new, |object| object.name.clone());
                }
                Ok((scene, Some(Content::Packed(packed))))
            }
        }
    }
}

impl Cast {
    /// The scene with further instances that show what moves where it ever is: all grids that are ever seen are packed with it, and a camera
    /// that sees everything sees all of it.
    fn all_at_once(&self) -> Scene {
        let mut all = self.base.clone();
        let length = f64::from(self.total) / self.fps;
        let moves = self.animation.moving(&self.base);
        let mut further: Vec<Instance> = Vec::new();
        for look in 0..LOOKS {
            let now = self.animation.scene_at(&self.base, length * f64::from(look) / f64::from(LOOKS));
            for (index, instance) in now.instances.into_iter().enumerate() {
                if now_visible(&self.base, &instance) && moves[index] {
                    further.push(Instance { keyframes: Vec::new(), repeats: None, name: String::new(), ..instance });
                }
            }
        }
        // Keyframes and choices of grids may be shorter than the time between two looks.
        let of_keys = self.base.instances.iter().flat_map(|instance| {
            instance.keyframes.iter().map(move |key| Instance {
                keyframes: Vec::new(),
                repeats: None,
                name: String::new(),
                grid: key.grid,
                world_from_grid: key.world_from_grid,
                ..instance.clone()
            })
        });
        further.extend(of_keys.filter(|_| self.animation.keyframe_rate > 0.0));
        let clip = playing(&self.base).filter(|_| self.animation.clip != Playback::Still);
        let shapes = clip.map(|(_, motion)| motion.all_shapes()).unwrap_or_default();
        further.extend(shapes.into_iter().map(|(index, grid, world_from_grid)| Instance {
            keyframes: Vec::new(),
            repeats: None,
            name: String::new(),
            grid,
            world_from_grid,
            ..self.base.instances[index].clone()
        }));
        let tracked = self.animation.objects.iter().flat_map(|track| track.instances.iter());
        // What appears later is packed, too.
        further.extend(tracked.map(|&index| Instance {
            hidden: false,
            keyframes: Vec::new(),
            repeats: None,
            ..self.base.instances[index].clone()
        }));
        all.instances.extend(further);
        all
    }
}

fn now_visible(base: &Scene, instance: &Instance) -> bool {
    base.is_visible(instance)
}

/// Numbers over time of a table with `keys`: what one key does not say is as in the key before.
fn curve<const N: usize>(
    table: &super::table::Table,
    name: &str,
    numbers: [&str; N],
    first: [f64; N],
) -> Result<Option<Curve<N>>, Failure> {
    let Some(table) = table.table(name)? else { return Ok(None) };
    table.only(&["keys", "interpolation"])?;
    let keys = table.tables("keys")?;
    if keys.is_empty() {
        return Err(table.fault("`keys` is missing"));
    }
    let (mut last, mut values) = (first, Vec::new());
    for (key, time) in keys.iter().zip(super::table::Table::times(&keys)?) {
        key.only(&["at"].into_iter().chain(numbers).collect::<Vec<_>>())?;
        for (value, name) in last.iter_mut().zip(numbers) {
            *value = key.number(name)?.unwrap_or(*value);
            let is_good = match name {
                "height" => value.abs() <= 90.0,
                "bearing" => true,
                _ => *value >= 0.0,
            };
            if !is_good {
                return Err(key.fault_at(name, if name == "height" { "from -90 to 90 degrees" } else { "at least 0" }));
            }
        }
        values.push((time, last));
    }
    Ok(Some(Curve::new(values, table.choice("interpolation", &objects::INTERPOLATIONS)?.unwrap_or_default())))
}
