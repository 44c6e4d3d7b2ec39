//! What the probes of a driver said: on the terminal, as JSON, and as Markdown for `docs/drivers`.

use serde_json::Value;
use voxtrace_vulkan::probe::{ProbeReport, ProbeRow};

/// The report and its verdict, for programs.
pub fn probes_json(report: &ProbeReport) -> Value {
    let mut value = serde_json::to_value(report).unwrap_or_default();
    value["verdict"] = report.verdict().into();
    value
}

/// The probes' table on the terminal.
pub fn probes_text(report: &ProbeReport) -> String {
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
pub fn probes_markdown(report: &ProbeReport) -> String {
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
            assert_eq!(page, probes_markdown(&report), "{}", path.display());
            assert!(readme.contains(&format!("({}.md)", report.file_stem())), "{}", path.display());
            report.probes[1].wrong += 1;
            assert_ne!(page, probes_markdown(&report), "another number is another page");
            pages += 1;
        }
        assert!(pages >= 2);
    }
}
