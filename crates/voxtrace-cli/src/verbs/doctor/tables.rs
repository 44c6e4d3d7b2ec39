//! What the doctor says, for people: on the terminal, and as Markdown for `docs/drivers`.

use super::advice::Advice;
use super::host::Host;
use super::manifests::Manifest;
use super::{NEEDS, remembered};
use voxtrace::TraceError;
use voxtrace_vulkan::probe::{ProbeReport, ProbeRow};
use voxtrace_vulkan::{DeviceInfo, missing};

const GIB: f64 = (1u64 << 30) as f64;

pub fn examination(
    host: &Host,
    manifests: &[Manifest],
    found: &Result<Vec<DeviceInfo>, TraceError>,
    advice: &Advice,
) -> String {
    let mut text = format!("voxtrace {} traces on {}.\n\n", env!("CARGO_PKG_VERSION"), advice.tracer);
    text += &format!("cpu      {} threads, instructions in use: {}", host.threads, host.simd);
    if !host.features.is_empty() {
        text += &format!(" (of {})", host.features.join(" "));
    }
    text += "\n";
    if let Some((total, free)) = host.memory {
        text += &format!("memory   {:.1} GiB, {:.1} GiB available\n", total as f64 / GIB, free as f64 / GIB);
    }
    text += &match found {
        Ok(found) => format!("vulkan   loader found, {} devices\n", found.len()),
        Err(error) => format!("vulkan   {error}\n"),
    };
    for manifest in manifests {
        let library = manifest.library.as_deref().unwrap_or("?");
        let fault = manifest.fault.as_ref().map_or(String::new(), |fault| format!(", but {fault}"));
        text += &format!("driver   {}: {library}{fault}\n", manifest.path.display());
    }
    for info in found.iter().flatten() {
        text += &format!(
            "\n{}        {} ({}, {:.1} GiB)\n",
            info.index,
            info.name,
            info.kind.name(),
            info.memory_bytes as f64 / GIB
        );
        text += &format!("         driver {}, Vulkan {}\n", info.driver, info.api_version);
        for (traversal, needs) in NEEDS {
            let state = match missing(info, traversal) {
                None => "yes".to_owned(),
                Some(why) => {
                    let lacks: Vec<&str> = needs.iter().copied().filter(|name| !info.has_extension(name)).collect();
                    match lacks.is_empty() {
                        true => format!("no: {why}"),
                        false => format!("no: the driver does not offer {}", lacks.join(", ")),
                    }
                }
            };
            text += &format!("         {:<9}{state}\n", traversal.name());
        }
        text += &format!("         probes   {}\n", remembered(info).1);
    }
    if !advice.lines.is_empty() {
        text += "\n";
        advice.lines.iter().for_each(|line| text += &format!("- {line}\n"));
    }
    text
}

/// The probes' table on the terminal.
pub fn probes(report: &ProbeReport) -> String {
    let mut text = format!(
        "{}, driver {}, Vulkan {}: {} probes in {:.1} s\n\n",
        report.device, report.driver, report.vulkan, report.effort, report.seconds
    );
    for row in &report.probes {
        text += &format!("{:<4}{:<15}{:<29}{}\n", row.id, row.outcome.name(), row.name, row.says);
    }
    text + &format!("\nVerdict: {}.\n", report.verdict())
}

fn outcome(row: &ProbeRow, traversal: &str) -> &'static str {
    let of_traversal = row.findings.iter().find(|finding| match &finding.traversal {
        Some(name) => name == traversal,
        None => true,
    });
    of_traversal.map_or("", |finding| finding.outcome.name())
}

/// The probes' page in `docs/drivers`.
pub fn markdown(report: &ProbeReport) -> String {
    let mut text = format!("# {}\n\n", report.file_stem());
    text += &format!(
        "{} ({}), driver {}, Vulkan {}. The {} probes, version {}, of voxtrace {}, by `voxtrace doctor --rt{}`, took {:.1} s. \
         [What each probe shows](README.md).\n\n**Verdict:** {}.\n\n",
        report.device,
        report.kind,
        report.driver,
        report.vulkan,
        report.effort,
        report.probe_version,
        report.voxtrace,
        if report.effort == "full" { " --full" } else { "" },
        report.seconds,
        report.verdict()
    );
    let columns: Vec<&str> = report.traversals.iter().map(String::as_str).collect();
    let head: String = columns.iter().map(|name| format!(" {name} |")).collect();
    text += &format!("| | probe | must hold |{head} tried | wrong | found |\n");
    text += &format!("|---|---|---|{}---:|---:|---|\n", "---|".repeat(columns.len()));
    for row in &report.probes {
        let outcomes: String = columns.iter().map(|name| format!(" {} |", outcome(row, name))).collect();
        let says = row.says.replace('|', "\\|");
        text += &format!(
            "| {} | {} | {} |{outcomes} {} | {} | {says} |\n",
            row.id, row.name, row.expects, row.rays, row.wrong
        );
    }
    text += "\n## The numbers\n";
    for row in &report.probes {
        for finding in row.findings.iter().filter(|finding| !finding.counts.is_empty()) {
            let numbers: Vec<String> = finding.counts.iter().map(|(name, count)| format!("{name} {count}")).collect();
            let traversal = finding.traversal.as_deref().unwrap_or("device");
            text += &format!("- {} {traversal}: {}\n", row.id, numbers.join(", "));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn the_pages_of_docs_drivers_are_what_their_json_gives_and_the_readme_names_them() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/drivers");
        let readme = std::fs::read_to_string(folder.join("README.md")).unwrap();
        let mut pages = 0;
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|extension| extension != "json") {
                continue;
            }
            let mut report: ProbeReport = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
            assert_eq!(path.file_stem().unwrap().to_str().unwrap(), report.file_stem());
            assert_eq!((report.probes.len(), report.effort.as_str()), (19, "full"), "{}", path.display());
            let page = std::fs::read_to_string(path.with_extension("md")).unwrap();
            assert_eq!(page, markdown(&report), "{}", path.display());
            assert!(readme.contains(&format!("({}.md)", report.file_stem())), "{}", path.display());
            report.probes[1].wrong += 1;
            assert_ne!(page, markdown(&report), "another number is another page");
            pages += 1;
        }
        assert!(pages >= 2);
    }
}
