//! What to type instead of options that other programs have.

/// Options of other programs, and what to say about each.
const INSTEAD: [(&[&str], &str); 15] = [
    (&["--width", "--res", "--image-size", "--output-size", "-w", "-s"], "--size 1280x720 says both, in pixels"),
    (&["--noise-threshold", "--quality"], "--noise 0.02 samples until noise is below, --spp N so often"),
    (&["--sampling", "--num-samples", "-n"], "--spp N"),
    (&["--fps", "--frame-rate", "--framerate"], "--frames N; whoever joins the pictures chooses the rate"),
    (
        &["--dof", "--depth-of-field", "--fstop", "--f-stop"],
        "--aperture RADIUS, in voxels, with --focus DISTANCE or --focus-on X,Y",
    ),
    (&["--bounces", "--depth", "--max-depth"], "--max-bounces N, and --diffuse-bounces and the like for one kind"),
    (&["--denoiser"], "--denoise, or --denoise oidn where Open Image Denoise is installed"),
    (
        &["--gpu", "--cuda", "--optix", "--vulkan"],
        "a GPU is taken where there is one; --traversal walk, query or pipeline and --device N choose",
    ),
    (&["--cpu"], "--traversal cpu traces on the CPU"),
    (&["--hdri", "--hdr", "--environment", "--env"], "--sky FILE.hdr or FILE.exr, and --sky-rotation DEGREES"),
    (&["--format", "--output-format", "-f"], "the output's name says it: -o picture.png, .exr or .vxf"),
    (&["--frame"], "--turntable or --flight TOML with --frames N for the one frame N"),
    (&["--position", "--cam-pos", "--from"], "--eye X,Y,Z, --target X,Y,Z and --up X,Y,Z"),
    (&["--timeout"], "--time-limit 30s, 5m or 1h30m"),
    (
        &["--isometric", "--ortho", "--orthographic", "--panorama", "--360"],
        "--projection isometric, orthographic, panorama or another; `voxtrace help render` lists them",
    ),
];

/// What to say about a value that an option of this name does not take: the name of another option may be meant.
pub fn for_value(option: &str, value: &str) -> Option<String> {
    let is_size = |text: &str| voxtrace_bench::quantity::size(text).is_ok();
    match option.split_whitespace().next()? {
        "--resolution" if is_size(value) => Some(format!(
            "--size {value} is the size of the picture; --resolution N counts voxels along the longest edge"
        )),
        "--frames" if value.contains(',') => {
            Some("--frames N makes one of them, and the others take a run each".into())
        }
        _ => None,
    }
}

/// What to say about an option that a verb does not have, as it was typed; `None` too where the verb has not what would be said.
pub fn for_option(typed: &str, verb: &clap::Command) -> Option<&'static str> {
    let name = typed.split('=').next()?;
    let (_, hint) = INSTEAD.iter().find(|(names, _)| names.contains(&name))?;
    options_in(hint).all(|option| has(verb, option)).then_some(hint)
}

fn has(verb: &clap::Command, option: &str) -> bool {
    let Some(long) = option.strip_prefix("--") else { return false };
    verb.get_arguments().any(|argument| argument.get_long() == Some(long))
}

fn options_in(hint: &str) -> impl Iterator<Item = &str> {
    hint.split(|c: char| !(c.is_alphanumeric() || c == '-')).filter(|word| word.starts_with("--"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Cli;
    use clap::CommandFactory;

    #[test]
    fn options_of_others_are_none_of_ours_and_what_is_said_instead_is_there() {
        let command = Cli::command();
        let render = command.find_subcommand("render").unwrap();
        for (names, hint) in INSTEAD {
            assert!(!names.iter().any(|name| has(render, name)), "{names:?}");
            assert!(options_in(hint).count() > 0 || hint.contains("-o "), "{hint}");
            options_in(hint).for_each(|option| assert!(has(render, option), "{hint}: {option}"));
        }
        assert!(has(render, "--size") && !has(render, "--width"));
        assert!(for_option("--width=64", render).is_some_and(|hint| hint.contains("--size")));
        assert_eq!(for_option("--width=64", render), for_option("--res", render));
        assert_eq!(for_option("--size", render), None);
        assert!(for_value("--resolution <N>", "1280x720").is_some_and(|hint| hint.contains("--size 1280x720")));
        assert_eq!((for_value("--resolution <N>", "many"), for_value("--seed <N>", "1280x720")), (None, None));
        // A verb without pictures has no size of them.
        assert_eq!(for_option("--width", command.find_subcommand("convert").unwrap()), None);
    }
}
