//! `report.html`: one file without scripts, for somebody who knows nothing of voxels, at a desk or on a phone, in light
//! and dark. The answer comes first, what the words mean next, then the numbers.

use super::charts;
use super::machine;
use super::plot;
use super::table::{Table, escape};
use super::tables;
use crate::measure::host;
use crate::quantity::counted;
use crate::results::verdict::{self, Verdict};
use crate::results::{Figures, Results, Row, SceneFacts};
use std::fmt::Write;
use std::path::Path;
use voxtrace::Integrator;

const STYLE: &str = "\
:root{color-scheme:light dark;--bg:#fff;--ink:#1f2328;--soft:#57606a;--line:#d0d7de;--card:#f6f8fa;--good:#1a7f37;--bad:#cf222e}
@media(prefers-color-scheme:dark){:root{--bg:#0d1117;--ink:#e6edf3;--soft:#9198a1;--line:#3d444d;--card:#151b23;--good:#3fb950;--bad:#f85149}}
*{box-sizing:border-box}body{margin:0;background:var(--bg);color:var(--ink);font:16px/1.55 system-ui,-apple-system,'Segoe UI',sans-serif;overflow-wrap:anywhere}
main{max-width:1100px;margin:0 auto;padding:24px 16px 64px}h1{font-size:1.5rem;line-height:1.25;margin:0 0 12px}h2{font-size:1.2rem;margin:44px 0 8px}h3{font-size:1rem;margin:20px 0 6px}
p{margin:8px 0;max-width:75ch}.soft,figcaption{color:var(--soft);font-size:.875rem}
.answer{border:1px solid var(--line);border-left:6px solid var(--soft);border-radius:8px;background:var(--card);padding:14px 18px;font-size:1.125rem;margin:12px 0}
.answer.yes{border-left-color:var(--good)}.answer.no{border-left-color:var(--bad)}.answer p{margin:4px 0;max-width:none}
.grid{display:grid;gap:16px;grid-template-columns:repeat(auto-fill,minmax(min(100%,310px),1fr))}
.wide{grid-template-columns:repeat(auto-fill,minmax(min(100%,440px),1fr))}
.card{border:1px solid var(--line);border-radius:8px;background:var(--card);padding:12px;min-width:0}.card h3{margin:8px 0 4px}
.card ul{list-style:none;margin:6px 0 0;padding:0}.card li{margin:3px 0}.good,.bad{font-weight:700}.good{color:var(--good)}.bad{color:var(--bad)}
figure{margin:0 0 12px;min-width:0}img,svg{display:block;width:100%;height:auto;border-radius:4px}img{image-rendering:auto;background:#000}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:8px;margin:8px 0}table{border-collapse:collapse;font-size:.8125rem;width:100%}
th,td{padding:5px 10px;text-align:left;border-bottom:1px solid var(--line);white-space:nowrap}th{background:var(--card)}tbody tr:last-child td{border-bottom:0}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td:last-child{white-space:normal;min-width:7em}.probes td:last-child{min-width:24em}dl{margin:8px 0;display:grid;gap:4px 32px;grid-template-columns:repeat(auto-fit,minmax(min(100%,420px),1fr))}dt{font-weight:600;margin-top:8px}dd{margin:0;max-width:75ch}
";

/// What the words of the page mean; `RAYS` stands for how many a path has.
const WORDS: [(&str, &str); 6] = [
    ("Voxel", "a small cube of one colour; a scene is made of millions of them, as a picture is made of pixels."),
    (
        "Path tracing",
        "light is followed backwards from the eye, ray by ray, through a few bounces off surfaces. Each frame sends one path \
         through every pixel, here of up to RAYS; frames are added up to a picture without noise.",
    ),
    (
        "GPU time",
        "how long the graphics processor itself worked on a frame, by its own clock. Frames a second are 1000 divided by the \
         mean milliseconds. Where there is no such clock, time on the wall stands in for it.",
    ),
    (
        "The demands",
        "those of the study this repeats (Ray Tracing Voxels with Hardware Acceleration in Real-Time, 2024): scenes of 3 to 15 \
         million voxels, at least 60 frames a second (16.67 ms each), at most 1 GB of memory.",
    ),
    (
        "Proved, stable",
        "a frame counts only when the device itself wrote down that it did the work, its clock moved, and its light is in the \
         picture that was read back. In the study, GPUs crashed and a run could count frames that were never drawn.",
    ),
    (
        "Conformant",
        "through the middle of every pixel the first voxel is the right one, compared with an exact walk on the processor. \
         Up to one in ten thousand may differ along edges, where rounding decides.",
    ),
];

/// The page. Pictures are read from the folder and put inside.
pub fn page(results: &Results, folder: &Path) -> String {
    let device = tables::device(results);
    let name = results.device.as_ref().map_or("this processor", |info| info.name.as_str());
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\
         <title>voxtrace bench: {}</title><style>{STYLE}{}</style></head><body><main>\n",
        escape(&device),
        plot::STYLE
    );
    let _ = writeln!(html, "<h1>Can {} path trace millions of voxels in real time?</h1>", escape(name));
    html += &answer(results);
    html += &words(results);
    html += &scenes(results, folder);
    html += &study(results);
    html += &chart_section(results);
    html += &approximation(results, folder);
    let _ = write!(html, "<h2>Everything that was measured</h2>\n{}", tables::all_cells(results).html());
    let _ = writeln!(html, "<p class=\"soft\">{}</p>", escape(tables::ALL_CELLS));
    let _ = write!(html, "<h3>Each cell against the demands</h3>\n{}", tables::verdicts(results).html());
    if !results.sweep.is_empty() {
        let _ = write!(html, "<h3>Sizes</h3>\n{}", tables::sweep(results).html());
    }
    html += &driver(results);
    html += &conditions(results);
    html + "</main></body></html>\n"
}

fn answer(results: &Results) -> String {
    let sentence = verdict::sentence(results);
    let class = match &sentence {
        text if text.starts_with("Yes") => "answer yes",
        text if text.starts_with("No:") => "answer no",
        _ => "answer",
    };
    let mut html = format!("<div class=\"{class}\"><p>{}</p></div>\n", escape(&sentence));
    if !results.is_complete {
        html += "<p><strong>Not complete: cells are missing. Run the same command with --resume.</strong></p>\n";
    }
    for caution in verdict::cautions(results) {
        let _ = writeln!(html, "<p class=\"soft\">{}</p>", escape(&caution));
    }
    html
}

fn words(results: &Results) -> String {
    let plan = &results.plan;
    let mut html = format!(
        "<h2>What was measured</h2>\n<p>{} drawn at {} × {} pixels in {}, for up to {} frames each, and every frame \
         was timed. The ways differ in how a ray finds the first voxel it meets; what light does then is the same.</p>\n<dl>",
        if results.scenes.len() == 1 {
            "One scene was".into()
        } else {
            format!("{} scenes were", results.scenes.len())
        },
        plan.width,
        plan.height,
        if plan.cells.len() == 1 { "one way".into() } else { format!("{} ways", plan.cells.len()) },
        plan.frames,
    );
    let rays = counted(u64::from(plan.max_bounces) + 1, "ray");
    let rays = match plan.integrator {
        Integrator::Essay => rays,
        Integrator::Path => format!("{rays}, those towards lights aside"),
    };
    for (word, meaning) in WORDS {
        let meaning = meaning.replace("RAYS", &rays);
        let _ = writeln!(html, "<div><dt>{}</dt><dd>{}</dd></div>", escape(word), escape(&meaning));
    }
    html + "</dl>\n"
}

/// A card for each scene: Figures 8 to 10 and the verdict.
fn scenes(results: &Results, folder: &Path) -> String {
    let mut html = "<h2>The verdict, scene by scene</h2>\n<div class=\"grid\">\n".to_owned();
    for (index, facts) in results.scenes.iter().enumerate() {
        let Some(row) = verdict::asked(results, index) else { continue };
        let Some((summary, verdict)) = row.summary().zip(Verdict::of(results, row)) else { continue };
        let rendered = results.rows.iter().filter(|row| row.scene == index && row.figures.render.is_some());
        let most = rendered.max_by_key(|other| (std::ptr::eq(*other, row), other.measured.frames.len()));
        html += "<section class=\"card\">";
        if let Some(picture) = most.and_then(|row| Some((row, row.figures.render.as_deref()?))) {
            let (shown, file) = picture;
            let caption = format!("Figure {}: {}, {}", 8 + index, facts.name, shown.cell.name());
            html += &image(folder, file, &caption);
        }
        let _ = write!(
            html,
            "<h3>{}</h3><p class=\"soft\">{} voxels, by {}</p><ul>",
            escape(&facts.name),
            verdict::millions(facts.voxels),
            row.cell.name()
        );
        let bytes = row.traced_bytes(facts);
        html += &item(
            Some(verdict.is_fast),
            &format!("60 frames a second? {} ({:.2} ms a frame)", verdict::rate(summary.fps), summary.mean),
        );
        html += &item(Some(verdict.is_small), &format!("At most 1 GB? {:.1} MB", bytes as f64 / 1e6));
        let lost = row.measured.lost;
        html += &item(Some(verdict.is_stable), &format!("Stable? {} frames proved, {lost} lost", summary.frames));
        let share = row
            .measured
            .conformance
            .map_or("not compared".into(), |found| format!("{:.4} % of the voxels are wrong", 100.0 * found.share()));
        html += &item(verdict.is_conformant, &format!("Conformant? {share}"));
        if let Some((best, quickest)) = verdict::best(results, index).and_then(|best| Some((best, best.summary()?)))
            && best.cell != row.cell
        {
            let megabytes = best.traced_bytes(facts) as f64 / 1e6;
            let _ = write!(
                html,
                "<li class=\"soft\">Quickest way: {}, {:.2} ms ({} frames a second), {megabytes:.1} MB</li>",
                escape(&best.cell.name()),
                quickest.mean,
                verdict::rate(quickest.fps)
            );
        }
        html += "</ul></section>\n";
    }
    html + "</div>\n"
}

fn item(is_met: Option<bool>, text: &str) -> String {
    let mark = match is_met {
        Some(true) => "<span class=\"good\">✓ yes</span>",
        Some(false) => "<span class=\"bad\">✗ no</span>",
        None => "<span>–</span>",
    };
    format!("<li>{mark} · {}</li>", escape(text))
}

fn study(results: &Results) -> String {
    let mut html = format!("<h2>Beside the study</h2>\n<p>{}</p>\n", escape(tables::STUDY_NOTE));
    let titles = [
        "Table 1: mean milliseconds a frame",
        "Table 2: frames a second",
        "Table 3: memory of voxel-exact, MB (AS: acceleration structures)",
    ];
    for (title, table) in titles.into_iter().zip(tables::study(results)) {
        let _ = write!(html, "<h3>{}</h3>\n{}", escape(title), table.html());
    }
    html
}

fn chart_section(results: &Results) -> String {
    let charts = charts::all(results);
    if charts.is_empty() {
        return String::new();
    }
    let mut html = "<h2>Charts</h2>\n<div class=\"grid wide\">\n".to_owned();
    for (_, plot) in charts {
        let _ = writeln!(html, "<figure class=\"card\">{}</figure>", plot.svg(false));
    }
    html + "</div>\n"
}

/// The study's Figure 7: exact above approximate, and a map of what is wrong.
fn approximation(results: &Results, folder: &Path) -> String {
    let mut html = String::new();
    for (index, facts) in results.scenes.iter().enumerate() {
        let is_approximate = |row: &&Row| row.scene == index && row.figures.voxels.is_some();
        let shown: Vec<(String, Figures, f64)> = results
            .rows
            .iter()
            .filter(is_approximate)
            .map(|row| {
                let share = row.measured.conformance.map_or(0.0, |found| found.share());
                (row.cell.name(), row.figures.clone(), share)
            })
            .chain(facts.emulation.iter().map(|emulation| {
                let how = format!(
                    "the rule emulated on the processor, boxes 1/{:.0} of a voxel larger",
                    1.0 / emulation.margin
                );
                (how, emulation.figures.clone(), emulation.conformance.share())
            }))
            .collect();
        html += &panels(facts, &shown, folder);
    }
    if html.is_empty() {
        return html;
    }
    let start = "<h2>Figure 7: what the nearest-centre rule gets wrong</h2>\n<p>The study's approximate method saves a test: of all boxes \
        that the hardware offers, the voxel whose centre is nearest wins. That is exact as long as every box that is offered is \
        really met by the ray. Hardware may offer boxes that the ray misses by a little; then a wrong voxel wins. Wrong voxels are \
        drawn black, and marked in the map on a dark ground.</p>\n";
    start.to_owned() + &html
}

fn panels(facts: &SceneFacts, shown: &[(String, Figures, f64)], folder: &Path) -> String {
    let Some((how, figures, share)) = shown.first() else { return String::new() };
    let mut html = format!("<h3>{}</h3>\n<div class=\"grid\">\n", escape(&facts.name));
    let wrong = format!("{how}: {:.4} % of the voxels are wrong (black)", 100.0 * share);
    let map = "where they are".to_owned();
    let panels = [
        (facts.exact_figure.as_ref(), "the right voxels".to_owned()),
        (figures.voxels.as_ref(), wrong),
        (figures.difference.as_ref(), map),
    ];
    for (file, caption) in panels {
        if let Some(file) = file {
            html += &image(folder, file, &caption);
        }
    }
    html + "</div>\n"
}

fn driver(results: &Results) -> String {
    let table = tables::probes(results).map_or_else(
        || {
            "<p class=\"soft\">No probes of the driver were at hand: <code>voxtrace doctor --rt</code> runs them.</p>\n"
                .to_owned()
        },
        |table: Table| format!("<div class=\"probes\">{}</div>", table.html()),
    );
    let verdict = results.doctor.as_ref().and_then(|doctor| doctor["verdict"].as_str());
    let verdict = verdict
        .map_or(String::new(), |verdict| format!("<p>What the driver promises, probed: {}.</p>\n", escape(verdict)));
    format!("<h2>The driver</h2>\n{verdict}{table}")
}

fn conditions(results: &Results) -> String {
    let mut html = "<h2>How, and on what</h2>\n".to_owned();
    let host = host();
    let text = |name: &str| host[name].as_str().map(str::to_owned);
    let parts: Vec<String> = ["processor", "system", "kernel"].into_iter().filter_map(text).collect();
    let _ =
        write!(html, "<p>{}</p>\n<p>{}</p>\n", escape(&tables::device(results)), escape(&tables::settings(results)));
    let _ = writeln!(html, "<p>{}</p>\n<p>{}</p>", escape(&parts.join(", ")), escape(&machine::origins(results)));
    html += &tables::scenes(results).html();
    let _ = write!(html, "<h3>The machine at work</h3>\n{}", machine::clocks(results).html());
    let _ = writeln!(html, "<p class=\"soft\">{}</p>", escape(machine::CLOCKS));
    let notes = tables::notes(results);
    if !notes.is_empty() {
        html += "<h3>What went wrong</h3>\n<ul>";
        html.extend(notes.iter().map(|note| format!("<li>{}</li>", escape(note))));
        html += "</ul>\n";
    }
    html + "<p class=\"soft\">Every number here is in results.json and the CSV files of the same folder; docs/results-format.md says how they come \
            about. Two reports: <code>voxtrace compare A B</code>.</p>\n"
}

/// A picture of the folder, inside the page; nothing where it is not there.
fn image(folder: &Path, file: &str, caption: &str) -> String {
    let Ok(bytes) = std::fs::read(folder.join(file)) else { return String::new() };
    let caption = escape(caption);
    let kind = if file.ends_with(".jpg") { "jpeg" } else { "png" };
    format!(
        "<figure><img alt=\"{caption}\" src=\"data:image/{kind};base64,{}\"><figcaption>{caption}</figcaption></figure>\n",
        base64(&bytes)
    )
}

/// Base64 (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let is_padding = digit > chunk.len();
            text.push(if is_padding { '=' } else { DIGITS[(word >> (18 - 6 * digit) & 63) as usize].into() });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_rfc() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")];
        for (plain, coded) in pairs {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
        assert_eq!(base64(&[0xff, 0xfe, 0xfd]), "//79");
    }
}
