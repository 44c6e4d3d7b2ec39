//! Who makes real-time pictures: the processor, or a device.

use super::situations::Step;
use super::{Args, Outcome};
use glam::Vec3;
use std::sync::Arc;
use voxtrace::{PackedScene, Tracer};
use voxtrace_realtime::{Parts, RealTime};
use voxtrace_vulkan::{Device, Options, Picture, Rate, Settings, VulkanTracer};

/// Makes the pictures of a situation.
pub enum Maker {
    Processor(Box<RealTime>),
    Device(Box<OnDevice>),
}

/// A device with its scene and picture.
pub struct OnDevice {
    device: Arc<Device>,
    pub tracer: VulkanTracer,
    scene: Option<Arc<PackedScene>>,
    picture: Option<Picture>,
}

impl Maker {
    pub fn new(args: &Args, parts: Parts) -> Outcome<Self> {
        Ok(match args.on_device {
            true => Self::Device(Box::new(OnDevice::new(args, parts)?)),
            false => Self::Processor(Box::new(RealTime::new(parts))),
        })
    }

    /// The picture of the next step.
    pub fn frame(&mut self, step: &Step) -> Outcome<Vec<Vec3>> {
        match self {
            Self::Processor(real_time) => {
                if step.is_changed {
                    real_time.change();
                }
                if let Some(before) = &step.moved_from {
                    real_time.move_instances(before);
                }
                Ok(real_time.frame(&step.scene, &step.frame))
            }
            Self::Device(device) => device.frame(step),
        }
    }
}

impl OnDevice {
    pub fn new(args: &Args, parts: Parts) -> Outcome<Self> {
        let device = Device::open(Options::default(), args.renderer.device.as_deref(), None)?;
        let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default())?;
        tracer.set_real_time(parts, false);
        Ok(Self { device, tracer, scene: None, picture: None })
    }

    /// The device's name.
    pub fn name(&self) -> &str {
        &self.device.info().name
    }

    /// Follows what happens.
    pub fn follow(&mut self, step: &Step) -> Outcome<()> {
        match (&step.patch, &step.moved_from) {
            (Some(patch), _) => self.tracer.patch(patch)?,
            (None, Some(_)) => self.tracer.set_placement(step.scene.placement())?,
            _ if self.scene.as_ref().is_none_or(|scene| !Arc::ptr_eq(scene, &step.scene)) => {
                self.tracer.set_scene(&step.scene)?;
            }
            _ => {}
        }
        self.scene = Some(Arc::clone(&step.scene));
        Ok(())
    }

    fn frame(&mut self, step: &Step) -> Outcome<Vec<Vec3>> {
        self.follow(step)?;
        let (width, height) = (step.frame.width, step.frame.height);
        let picture = match self.picture.take() {
            Some(picture) => picture,
            None => Picture::new(&self.device, width, height, true)?,
        };
        self.tracer.show_real_time(&step.frame, Rate::Full, &picture)?;
        let radiance = picture.radiance().into_iter().map(Vec3::from).collect();
        self.picture = Some(picture);
        Ok(radiance)
    }

    /// A picture that stays on the device.
    pub fn picture(&self, width: u32, height: u32) -> Outcome<Picture> {
        Ok(Picture::new(&self.device, width, height, false)?)
    }
}
