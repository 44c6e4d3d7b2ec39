//! The bytes of the film file, as `docs/film-format.md` describes them: little-endian, a magic number and a version
//! first, a checksum over everything last.

use super::film_input::Input;
use super::{FilmFile, FilmFileError, SceneStamp};
use glam::{IVec3, Vec3};
use voxtrace_core::cuts::{Cuts, MAX_PLANES};
use voxtrace_core::film::{AovPixel, Film, Pixel};
use voxtrace_core::lines::{GridLines, Line, Lines};
use voxtrace_core::{BounceLimits, Frame, Integrator, LightGroup, Region};
use voxtrace_scene::sky::{Background, Environment, EnvironmentMap, Gradient};
use voxtrace_scene::{Camera, Lens, Sky, Sun};
use xxhash_rust::xxh3::xxh3_64;

/// The first bytes of a film file.
pub const MAGIC: &[u8; 8] = b"voxfilm\0";
/// The version of films whose camera is a pinhole, that of others, which say the lens, that of films under an environment map, which hold
/// it, and that of films of scenes that are cut, which say the kind of sky and the cuts.
const VERSION: u32 = 1;
const VERSION_OF_LENSES: u32 = 2;
const VERSION_OF_ENVIRONMENTS: u32 = 3;
const VERSION_OF_CUTS: u32 = 4;
const PIXEL_BYTES: usize = 32;
const AOV_BYTES: usize = 44;
/// What follows the pixels, as bits.
const HAS_AOVS: u32 = 1;
const HAS_EARLIER: u32 = 2;
const HAS_LIMITS: u32 = 4;
const HAS_GROUPS: u32 = 8;
const IS_CLEAR: u32 = 16;
const CATCHES_SHADOWS: u32 = 32;
const HIDES_SUN_DISC: u32 = 64;
const HAS_LINES: u32 = 128;
const KNOWN: u32 = 2 * HAS_LINES - 1;

impl FilmFile {
    /// The file's bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(512 + self.film.pixels.len() * (PIXEL_BYTES + AOV_BYTES));
        out.extend_from_slice(MAGIC);
        let has_lens = self.frame.camera.lens != Lens::Pinhole;
        let version = match self.scene.sky.background() {
            _ if !self.scene.cuts.is_none() => VERSION_OF_CUTS,
            Background::Environment(_) => VERSION_OF_ENVIRONMENTS,
            Background::Gradient(_) if has_lens => VERSION_OF_LENSES,
            Background::Gradient(_) => VERSION,
        };
        put_u32(&mut out, version);
        put_frame(&mut out, &self.frame, version);
        put_scene(&mut out, &self.scene, version);
        let (has_limits, has_groups) = (has_limits(&self.frame), !self.film.groups.is_empty());
        let planes = [
            (self.film.aovs.is_some(), HAS_AOVS),
            (self.film.earlier.is_some(), HAS_EARLIER),
            (has_limits, HAS_LIMITS),
            (has_groups, HAS_GROUPS),
            (self.frame.clear_shadows, IS_CLEAR),
            (self.frame.shadow_catcher, CATCHES_SHADOWS),
            (!self.scene.sky.is_sun_disc_visible(), HIDES_SUN_DISC),
            (!self.frame.lines.is_none(), HAS_LINES),
        ];
        put_u32(&mut out, planes.into_iter().filter(|(is_there, _)| *is_there).map(|(_, bit)| bit).sum());
        if has_limits {
            put_u32(&mut out, self.frame.bounce_limits.to_bits());
            put_f32(&mut out, self.frame.clamp_indirect);
            put_u32(&mut out, self.frame.light_group as u32);
        }
        if !self.frame.lines.is_none() {
            put_lines(&mut out, &self.frame.lines);
        }
        self.film.pixels.iter().for_each(|pixel| put_pixel(&mut out, pixel));
        for aov in self.film.aovs.iter().flatten() {
            put_vec3(&mut out, aov.albedo);
            put_vec3(&mut out, aov.normal);
            put_f32(&mut out, aov.depth);
            put_u32(&mut out, aov.instance);
            aov.voxel.to_array().into_iter().for_each(|v| out.extend_from_slice(&v.to_le_bytes()));
        }
        self.film.earlier.iter().flatten().for_each(|pixel| put_pixel(&mut out, pixel));
        if has_groups {
            put_u32(&mut out, self.film.groups.len() as u32);
        }
        for (group, pixels) in &self.film.groups {
            put_u32(&mut out, *group as u32);
            pixels.iter().for_each(|pixel| put_pixel(&mut out, pixel));
        }
        let checksum = xxh3_64(&out);
        out.extend_from_slice(&checksum.to_le_bytes());
        out
    }

    /// Reads the bytes that [`Self::to_bytes`] made.
    ///
    /// # Errors
    /// [`FilmFileError`] if they are anything else.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FilmFileError> {
        if !bytes.starts_with(MAGIC) {
            return Err(FilmFileError::Format("not a film file".into()));
        }
        let mut input = Input { bytes, at: MAGIC.len() };
        let version = input.u32()?;
        if !(VERSION..=VERSION_OF_CUTS).contains(&version) {
            let read = format!("this build reads versions up to {VERSION_OF_CUTS}");
            return Err(FilmFileError::Format(format!("film file of version {version}; {read}")));
        }
        let content = bytes.len().checked_sub(8).ok_or_else(|| input.damaged("the file ends early"))?;
        if xxh3_64(&bytes[..content]).to_le_bytes() != bytes[content..] {
            return Err(FilmFileError::Damaged { what: "the checksum does not match", offset: content as u64 });
        }
        input.bytes = &bytes[..content];
        let mut frame = input.frame(version >= VERSION_OF_LENSES)?;
        let mut scene = input.scene(version)?;
        let planes = input.u32()?;
        if planes & !KNOWN != 0 {
            return Err(input.damaged("unknown planes follow the pixels"));
        }
        frame = if planes & HAS_LIMITS != 0 { input.limits(frame)? } else { frame };
        frame = if planes & HAS_LINES != 0 { input.lines(frame)? } else { frame };
        scene.sky.set_sun_disc_visible(planes & HIDES_SUN_DISC == 0);
        frame = frame.clear_shadows(planes & IS_CLEAR != 0).shadow_catcher(planes & CATCHES_SHADOWS != 0);
        let film = input.film(&frame, planes)?;
        if input.at != content {
            return Err(input.damaged("bytes follow the film"));
        }
        Ok(Self { frame, scene, film })
    }
}

/// Lines along edges and of a grid, each a width, 0 for none, and a colour; and the spacing of the grid.
fn put_lines(out: &mut Vec<u8>, lines: &Lines) {
    let grid = lines.grid.map(|grid| grid.line);
    for line in [lines.edges, grid] {
        put_f32(out, line.map_or(0.0, |line| line.width));
        put_vec3(out, line.map_or(Vec3::ZERO, |line| line.color));
    }
    put_u32(out, lines.grid.map_or(1, |grid| grid.spacing));
}

/// Whether a frame says more about paths and lights than their number of bounces.
fn has_limits(frame: &Frame) -> bool {
    let is_usual = frame.bounce_limits == BounceLimits::default() && frame.light_group == LightGroup::All;
    !is_usual || frame.clamp_indirect < f32::INFINITY
}

fn put_u32(out: &mut Vec<u8>, value: u32) {
    out.extend_from_slice(&value.to_le_bytes());
}

fn put_f32(out: &mut Vec<u8>, value: f32) {
    out.extend_from_slice(&value.to_le_bytes());
}

fn put_vec3(out: &mut Vec<u8>, value: Vec3) {
    value.to_array().into_iter().for_each(|v| put_f32(out, v));
}

fn put_text(out: &mut Vec<u8>, text: &str) {
    put_u32(out, text.len() as u32);
    out.extend_from_slice(text.as_bytes());
}

fn put_pixel(out: &mut Vec<u8>, pixel: &Pixel) {
    pixel.radiance.iter().for_each(|sum| out.extend_from_slice(&sum.to_le_bytes()));
    put_u32(out, pixel.samples);
    put_u32(out, pixel.covered);
}

fn put_frame(out: &mut Vec<u8>, frame: &Frame, version: u32) {
    put_text(out, &frame.camera.name);
    [frame.camera.eye, frame.camera.target, frame.camera.up].into_iter().for_each(|v| put_vec3(out, v));
    put_f32(out, frame.camera.fov_y);
    if version >= VERSION_OF_LENSES {
        let (lens, numbers) = frame.camera.lens.to_numbers();
        put_u32(out, lens);
        numbers.into_iter().for_each(|number| put_f32(out, number));
    }
    let Region { x0, y0, x1, y1 } = frame.region;
    let numbers = [frame.width, frame.height, x0, y0, x1, y1, frame.first_sample, frame.samples, frame.seed];
    numbers.into_iter().for_each(|v| put_u32(out, v));
    let choices = [frame.max_bounces, frame.integrator as u32, frame.transparent.into(), frame.aovs.into()];
    choices.into_iter().for_each(|v| put_u32(out, v));
}

fn put_scene(out: &mut Vec<u8>, scene: &SceneStamp, version: u32) {
    put_text(out, &scene.name);
    out.extend_from_slice(&scene.content_hash.to_le_bytes());
    put_f32(out, scene.light_intensity);
    if version >= VERSION_OF_CUTS {
        put_u32(out, scene.sky.background().environment().is_some().into());
    }
    match scene.sky.background() {
        Background::Gradient(gradient) => {
            put_vec3(out, gradient.nadir);
            put_vec3(out, gradient.zenith);
        }
        Background::Environment(environment) => {
            put_u32(out, environment.map().edge());
            put_f32(out, environment.rotation());
            environment.map().texels().iter().for_each(|texel| put_vec3(out, texel.radiance));
        }
    }
    put_f32(out, scene.sky.brightness());
    put_u32(out, u32::from(scene.sky.sun().is_some()));
    if let Some(sun) = scene.sky.sun() {
        put_vec3(out, sun.direction);
        put_f32(out, sun.angular_radius);
        put_vec3(out, sun.irradiance);
    }
    if version >= VERSION_OF_CUTS {
        put_u32(out, scene.cuts.planes().len() as u32);
        for plane in scene.cuts.planes() {
            put_vec3(out, plane.normal());
            put_f32(out, plane.offset());
        }
        put_u32(out, scene.cuts.casts_shadows().into());
    }
}

impl Input<'_> {
    fn lens(&mut self) -> Result<Lens, FilmFileError> {
        let (lens, numbers) = (self.u32()?, [self.f32()?, self.f32()?, self.f32()?, self.f32()?]);
        Lens::from_numbers(lens, numbers).ok_or_else(|| self.damaged("the lens is unknown or out of range"))
    }

    fn frame(&mut self, has_lens: bool) -> Result<Frame, FilmFileError> {
        let camera = Camera {
            name: self.text()?,
            eye: self.vec3()?,
            target: self.vec3()?,
            up: self.vec3()?,
            fov_y: self.f32()?,
            lens: if has_lens { self.lens()? } else { Lens::Pinhole },
        };
        let (width, height) = (self.u32()?, self.u32()?);
        let region = Region { x0: self.u32()?, y0: self.u32()?, x1: self.u32()?, y1: self.u32()? };
        if region.x0 >= region.x1 || region.y0 >= region.y1 || region.x1 > width || region.y1 > height {
            return Err(self.damaged("the region is not a part of the picture"));
        }
        let (first_sample, samples, seed, max_bounces) = (self.u32()?, self.u32()?, self.u32()?, self.u32()?);
        let integrator = match self.u32()? {
            0 => Integrator::Essay,
            1 => Integrator::Path,
            _ => return Err(self.damaged("unknown integrator")),
        };
        let (transparent, aovs) = (self.flag()?, self.flag()?);
        Ok(Frame::new(camera, width, height)
            .region(region)
            .first_sample(first_sample)
            .samples(samples)
            .seed(seed)
            .max_bounces(max_bounces)
            .integrator(integrator)
            .transparent(transparent)
            .aovs(aovs))
    }

    fn limits(&mut self, frame: Frame) -> Result<Frame, FilmFileError> {
        let (kinds, clamp_indirect, group) = (self.u32()?, self.f32()?, self.u32()?);
        if clamp_indirect.is_nan() || clamp_indirect <= 0.0 {
            return Err(self.damaged("indirect light is clamped to no number above 0"));
        }
        let known = [LightGroup::All].into_iter().chain(LightGroup::PARTS).find(|known| *known as u32 == group);
        let group = known.ok_or_else(|| self.damaged("unknown light group"))?;
        Ok(frame.bounce_limits(BounceLimits::from_bits(kinds)).clamp_indirect(clamp_indirect).light_group(group))
    }

    fn lines(&mut self, frame: Frame) -> Result<Frame, FilmFileError> {
        let mut line = || -> Result<_, FilmFileError> { Ok((self.f32()?, self.vec3()?)) };
        let [edges, grid] = [line()?, line()?].map(|(width, color)| (width != 0.0).then_some(Line { width, color }));
        let spacing = self.u32()?;
        let lines = Lines { edges, grid: grid.map(|line| GridLines { line, spacing }) };
        lines.check().map_err(|_| self.damaged("lines are of no width or colour that there is"))?;
        Ok(frame.lines(lines))
    }

    fn environment(&mut self) -> Result<Environment, FilmFileError> {
        let (edge, rotation) = (self.u32()?, self.f32()?);
        let count =
            (edge as usize).checked_mul(edge as usize).ok_or_else(|| self.damaged("the environment is too large"))?;
        // Checked before anything of that size is allocated.
        if count > (self.bytes.len() - self.at) / 12 {
            return Err(self.damaged("the file ends early"));
        }
        let texels = (0..count).map(|_| self.vec3()).collect::<Result<Vec<_>, _>>()?;
        let map = EnvironmentMap::new(edge, &texels).map_err(|_| self.damaged("the environment is no light"))?;
        Ok(Environment::new(map.into(), rotation))
    }

    fn cuts(&mut self) -> Result<Cuts, FilmFileError> {
        let count = self.u32()?;
        if count as usize > MAX_PLANES {
            return Err(self.damaged("too many planes cut the scene"));
        }
        let planes = (0..count).map(|_| Ok((self.vec3()?, self.f32()?))).collect::<Result<Vec<_>, FilmFileError>>()?;
        let casts_shadows = self.flag()?;
        Cuts::from_parts(&planes, casts_shadows).map_err(|_| self.damaged("what cuts the scene is no plane"))
    }

    fn scene(&mut self, version: u32) -> Result<SceneStamp, FilmFileError> {
        let (name, content_hash, light_intensity) = (self.text()?, self.u64()?, self.f32()?);
        let has_environment = match version >= VERSION_OF_CUTS {
            true => self.flag()?,
            false => version >= VERSION_OF_ENVIRONMENTS,
        };
        let background = match has_environment {
            true => Background::Environment(self.environment()?),
            false => Background::Gradient(Gradient { nadir: self.vec3()?, zenith: self.vec3()? }),
        };
        let brightness = self.f32()?;
        let sun = match self.flag()? {
            true => Some(Sun { direction: self.vec3()?, angular_radius: self.f32()?, irradiance: self.vec3()? }),
            false => None,
        };
        let sky = Sky::new(background).with_brightness(brightness).with_sun(sun);
        let cuts = if version >= VERSION_OF_CUTS { self.cuts()? } else { Cuts::default() };
        Ok(SceneStamp { name, content_hash, sky, light_intensity, cuts })
    }

    fn film(&mut self, frame: &Frame, planes: u32) -> Result<Film, FilmFileError> {
        let pixels = u64::from(frame.region.width()) * u64::from(frame.region.height());
        let (has_aovs, has_earlier) = (planes & HAS_AOVS != 0, planes & HAS_EARLIER != 0);
        let with = |is_there: bool, bytes: usize| if is_there { bytes } else { 0 };
        let size = (PIXEL_BYTES + with(has_aovs, AOV_BYTES) + with(has_earlier, PIXEL_BYTES)) as u64;
        // Checked before anything of that size is allocated. Groups say themselves how many they are.
        let (least, there) = (pixels.checked_mul(size), (self.bytes.len() - self.at) as u64);
        if least.is_none_or(|least| least > there || (planes & HAS_GROUPS == 0 && least < there)) {
            return Err(self.damaged("the file does not hold as many pixels as it says"));
        }
        let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
        for pixel in &mut film.pixels {
            *pixel = self.pixel()?;
        }
        if has_aovs {
            let aovs = (0..pixels).map(|_| self.aov()).collect::<Result<_, _>>()?;
            film.aovs = Some(aovs);
        }
        if has_earlier {
            let earlier: Vec<Pixel> = (0..pixels).map(|_| self.pixel()).collect::<Result<_, _>>()?;
            if earlier.iter().zip(&film.pixels).any(|(earlier, pixel)| earlier.samples > pixel.samples) {
                return Err(self.damaged("earlier pixels hold more samples than the film"));
            }
            film.earlier = Some(earlier);
        }
        if planes & HAS_GROUPS != 0 {
            film.groups = self.groups(pixels)?;
        }
        Ok(film)
    }

    fn groups(&mut self, pixels: u64) -> Result<Vec<(LightGroup, Vec<Pixel>)>, FilmFileError> {
        let count = u64::from(self.u32()?);
        if pixels.checked_mul(PIXEL_BYTES as u64).and_then(|bytes| (bytes + 4).checked_mul(count))
            != Some((self.bytes.len() - self.at) as u64)
        {
            return Err(self.damaged("the file does not hold as many light groups as it says"));
        }
        let mut groups: Vec<(LightGroup, Vec<Pixel>)> = Vec::new();
        for _ in 0..count {
            let number = self.u32()?;
            let group = LightGroup::PARTS.into_iter().find(|group| *group as u32 == number);
            let group = group.filter(|group| groups.iter().all(|(other, _)| other != group));
            let group = group.ok_or_else(|| self.damaged("a light group is unknown or there twice"))?;
            groups.push((group, (0..pixels).map(|_| self.pixel()).collect::<Result<_, _>>()?));
        }
        Ok(groups)
    }

    fn pixel(&mut self) -> Result<Pixel, FilmFileError> {
        Ok(Pixel { radiance: [self.u64()?, self.u64()?, self.u64()?], samples: self.u32()?, covered: self.u32()? })
    }

    fn aov(&mut self) -> Result<AovPixel, FilmFileError> {
        let (albedo, normal, depth, instance) = (self.vec3()?, self.vec3()?, self.f32()?, self.u32()?);
        let voxel = IVec3::new(self.u32()? as i32, self.u32()? as i32, self.u32()? as i32);
        Ok(AovPixel { albedo, normal, depth, instance, voxel })
    }
}
