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
    (&["--time", "--timeout"], "--time-limit 30s, 5m or 1h30m"),
    (
        &["--isometric", "--ortho", "--orthographic", "--panorama", "--360"],
        "--projection isometric, orthographic, panorama or another; `voxtrace help render` lists them",
    ),
];

/// What to say about an option that this program does not have, as it was typed.
pub fn for_option(typed: &str) -> Option<&'static str> {
    let name = typed.split('=').next()?;
    INSTEAD.iter().find(|(names, _)| names.contains(&name)).map(|(_, hint)| *hint)
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
        let ours = |name: &str| {
            render.get_arguments().any(|argument| argument.get_long().is_some_and(|long| format!("--{long}") == name))
        };
        for (names, hint) in INSTEAD {
            assert!(!names.iter().any(|name| ours(name)), "{names:?}");
            let said = hint.split(|c: char| !(c.is_alphanumeric() || c == '-')).filter(|word| word.starts_with("--"));
            assert!(said.clone().count() > 0 || hint.contains("-o "), "{hint}");
            said.for_each(|option| assert!(ours(option), "{hint}: {option}"));
        }
        assert!(ours("--size") && !ours("--width"));
        assert_eq!(for_option("--width=64"), for_option("--res"));
        assert_eq!(for_option("--size"), None);
    }
}
