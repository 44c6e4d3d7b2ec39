//! What to type instead of options that other programs have.

/// Options of other programs, and what to say about each.
const INSTEAD: [(&[&str], &str); 12] = [
    (&["--width", "--res", "--image-size", "--output-size"], "--size 1280x720 says both, in pixels"),
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
    (&["--format", "-f"], "the output's name says it: -o picture.png, .exr or .vxf"),
    (&["--frame"], "--turntable or --flight TOML with --frames N for the one frame N"),
    (&["--position", "--cam-pos", "--from"], "--eye X,Y,Z, --target X,Y,Z and --up X,Y,Z"),
    (&["--timeout"], "--time-limit 30s, 5m or 1h30m"),
    (
        &["--isometric", "--ortho", "--orthographic", "--panorama", "--360"],
        "--projection isometric, orthographic, panorama or another; `voxtrace help render` lists them",
    ),
];

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
        // A verb without pictures has no size of them.
        assert_eq!(for_option("--width", command.find_subcommand("convert").unwrap()), None);
    }
}
