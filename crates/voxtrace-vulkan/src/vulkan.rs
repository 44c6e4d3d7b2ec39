//! The Vulkan loader and the instance: the door to all devices. Loaded at run time, so that a machine without Vulkan
//! runs everything else.

#[cfg(feature = "faults")]
use crate::faults::{self, Faults};
use ash::{ext, khr, vk};
use std::ffi::{CStr, c_void};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use voxtrace_core::TraceError;

/// How to open Vulkan.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Whether to turn on the validation layer; an error where it is not installed.
    pub validation: bool,
    /// Errors to plant, for tests.
    #[cfg(feature = "faults")]
    #[doc(hidden)]
    pub faults: Option<Arc<Faults>>,
    /// Extensions of the instance with which a window's surface is made; devices can then present pictures. Empty where there is
    /// no window.
    pub surface_extensions: Vec<&'static CStr>,
}

impl Options {
    /// As the environment says: `VOXTRACE_VALIDATION=1` turns validation on.
    pub fn from_environment() -> Self {
        let is_on = std::env::var("VOXTRACE_VALIDATION").is_ok_and(|value| value == "1");
        Self { validation: is_on, ..Self::default() }
    }

    /// For devices that draw into windows, whose surfaces are made with these extensions of the instance.
    pub fn for_window(validation: bool, surface_extensions: Vec<&'static CStr>) -> Self {
        Self {
            validation,
            surface_extensions,
            #[cfg(feature = "faults")]
            faults: None,
        }
    }

    /// Whether neither validation nor planted errors nor a window are asked for.
    fn is_plain(&self) -> bool {
        #[cfg(feature = "faults")]
        if self.faults.is_some() {
            return false;
        }
        !self.validation && self.surface_extensions.is_empty()
    }
}

/// Most messages of the validation layer that are kept word for word.
const MESSAGES_KEPT: usize = 16;
const VALIDATION_LAYER: &CStr = c"VK_LAYER_KHRONOS_validation";

/// What the validation layer said.
#[derive(Debug, Default)]
pub struct Messages {
    count: AtomicU32,
    first: Mutex<Vec<String>>,
}

impl Messages {
    /// Number of warnings and errors so far.
    pub fn count(&self) -> u32 {
        self.count.load(Ordering::Relaxed)
    }

    /// The first of them.
    pub fn first(&self) -> Vec<String> {
        self.first.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn add(&self, message: String) {
        self.count.fetch_add(1, Ordering::Relaxed);
        let mut first = self.first.lock().unwrap_or_else(PoisonError::into_inner);
        if first.len() < MESSAGES_KEPT {
            first.push(message);
        }
    }
}

/// An open instance of Vulkan.
pub struct Vulkan {
    // Dropped after the instance is destroyed: it holds the library.
    entry: ash::Entry,
    pub(crate) instance: ash::Instance,
    debug: Option<(ext::debug_utils::Instance, vk::DebugUtilsMessengerEXT)>,
    messages: Arc<Messages>,
    pub(crate) options: Options,
}

/// The instance without validation and planted faults, once it was opened. It stays open: a driver that was unloaded and
/// loaded again some dozens of times was not found any more (NVIDIA 580.159.04).
static PLAIN: Mutex<Option<Arc<Vulkan>>> = Mutex::new(None);

impl Vulkan {
    /// Loads Vulkan, once in a process for plain options.
    ///
    /// # Errors
    /// [`TraceError::Unsupported`] where the machine has no loader, or lacks the validation layer that was asked for.
    pub fn open(options: Options) -> Result<Arc<Self>, TraceError> {
        if !options.is_plain() {
            return Self::load(options);
        }
        let mut plain = PLAIN.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(vulkan) = &*plain {
            return Ok(Arc::clone(vulkan));
        }
        Ok(Arc::clone(plain.insert(Self::load(options)?)))
    }

    fn load(options: Options) -> Result<Arc<Self>, TraceError> {
        // SAFETY: the library of this name is the Vulkan loader, whose start-up code is sound.
        let entry = unsafe { ash::Entry::load() }
            .map_err(|_| TraceError::Unsupported("this machine has no Vulkan loader (libvulkan)".into()))?;
        let messages = Arc::new(Messages::default());
        let application = vk::ApplicationInfo::default()
            .application_name(c"voxtrace")
            .engine_name(c"voxtrace")
            .api_version(vk::API_VERSION_1_2);
        let (mut layers, mut extensions) = (Vec::new(), Vec::new());
        if options.validation {
            layers.push(VALIDATION_LAYER.as_ptr());
            extensions.push(ext::debug_utils::NAME.as_ptr());
        }
        extensions.extend(options.surface_extensions.iter().map(|name| name.as_ptr()));
        // Without it loaders leave out drivers that are not Vulkan in full: on macOS the only one. What such a device lacks is asked for as of any other.
        let flags = if offers(&entry, khr::portability_enumeration::NAME) {
            extensions.push(khr::portability_enumeration::NAME.as_ptr());
            vk::InstanceCreateFlags::ENUMERATE_PORTABILITY_KHR
        } else {
            vk::InstanceCreateFlags::empty()
        };
        let mut messenger = messenger_info(&messages);
        let mut info = vk::InstanceCreateInfo::default()
            .flags(flags)
            .application_info(&application)
            .enabled_layer_names(&layers)
            .enabled_extension_names(&extensions);
        if options.validation {
            info = info.push_next(&mut messenger);
        }
        // SAFETY: the infos and the strings that they point to live until the call returns.
        let instance = unsafe { entry.create_instance(&info, None) }.map_err(|error| match error {
            vk::Result::ERROR_LAYER_NOT_PRESENT => {
                TraceError::Unsupported("the Vulkan validation layer is not installed".into())
            }
            vk::Result::ERROR_INCOMPATIBLE_DRIVER => {
                TraceError::Unsupported("this machine has no Vulkan driver".into())
            }
            vk::Result::ERROR_EXTENSION_NOT_PRESENT if !options.surface_extensions.is_empty() => {
                TraceError::Unsupported("this machine's Vulkan cannot show pictures in windows".into())
            }
            error => TraceError::Unsupported(format!(
                "Vulkan cannot be started: {error}; with VK_LOADER_DEBUG=error in the environment its loader says why"
            )),
        })?;
        #[cfg(feature = "faults")]
        let instance = match &options.faults {
            Some(faults) => faults::instance_with_faults(&entry, instance, faults),
            None => instance,
        };
        let debug = options.validation.then(|| {
            let utils = ext::debug_utils::Instance::new(&entry, &instance);
            // SAFETY: the extension is enabled; the messages outlive the messenger, which `drop` destroys first.
            let messenger = unsafe { utils.create_debug_utils_messenger(&messenger_info(&messages), None) };
            (utils, messenger.unwrap_or_default())
        });
        Ok(Arc::new(Self { entry, instance, debug, messages, options }))
    }

    /// What the validation layer said.
    pub fn messages(&self) -> &Messages {
        &self.messages
    }

    /// The loader, with which extensions of the instance are found.
    pub fn entry(&self) -> &ash::Entry {
        &self.entry
    }

    /// The instance, for whoever makes a surface. It must not be destroyed.
    pub fn instance(&self) -> &ash::Instance {
        &self.instance
    }
}

/// Whether the loader has an extension of instances.
fn offers(entry: &ash::Entry, extension: &CStr) -> bool {
    // SAFETY: the loader is loaded, and no layer is named.
    let offered = unsafe { entry.enumerate_instance_extension_properties(None) }.unwrap_or_default();
    offered.iter().any(|offered| offered.extension_name_as_c_str() == Ok(extension))
}

impl Drop for Vulkan {
    fn drop(&mut self) {
        // SAFETY: devices keep this value alive, so that there are none left.
        unsafe {
            if let Some((utils, messenger)) = &self.debug {
                utils.destroy_debug_utils_messenger(*messenger, None);
            }
            self.instance.destroy_instance(None);
        }
    }
}

fn messenger_info(messages: &Arc<Messages>) -> vk::DebugUtilsMessengerCreateInfoEXT<'static> {
    let severity = vk::DebugUtilsMessageSeverityFlagsEXT::WARNING | vk::DebugUtilsMessageSeverityFlagsEXT::ERROR;
    let types = vk::DebugUtilsMessageTypeFlagsEXT::GENERAL
        | vk::DebugUtilsMessageTypeFlagsEXT::VALIDATION
        | vk::DebugUtilsMessageTypeFlagsEXT::PERFORMANCE;
    vk::DebugUtilsMessengerCreateInfoEXT::default()
        .message_severity(severity)
        .message_type(types)
        .pfn_user_callback(Some(on_message))
        .user_data(Arc::as_ptr(messages) as *mut c_void)
}

/// Called by the validation layer.
unsafe extern "system" fn on_message(
    _: vk::DebugUtilsMessageSeverityFlagsEXT,
    _: vk::DebugUtilsMessageTypeFlagsEXT,
    data: *const vk::DebugUtilsMessengerCallbackDataEXT<'_>,
    messages: *mut c_void,
) -> vk::Bool32 {
    // SAFETY: the layer gives a valid record with a string that ends; `messages` is the pointer that `messenger_info` set,
    // whose value outlives the instance.
    let (text, messages) = unsafe {
        let text = (*data).message_as_c_str().unwrap_or(c"");
        (text.to_string_lossy().into_owned(), &*messages.cast::<Messages>())
    };
    messages.add(text);
    vk::FALSE
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_test_support::{Need, skip_without};

    #[test]
    fn one_instance_serves_a_process() {
        let Ok(first) = Vulkan::open(Options::default()) else {
            skip_without(Need::Vulkan, "no Vulkan loader");
            return;
        };
        let second = Vulkan::open(Options::default()).unwrap();
        assert!(Arc::ptr_eq(&first, &second));
        if let Ok(validated) = Vulkan::open(Options { validation: true, ..Options::default() }) {
            assert!(!Arc::ptr_eq(&first, &validated), "validation has an instance of its own");
        }
    }
}
