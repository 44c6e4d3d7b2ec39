//! The report: tables, charts and pictures, as one page, as Markdown and for a terminal, in a folder.

mod charts;
mod figures;
mod folder;
mod html;
mod machine;
mod plot;
mod table;
mod tables;
mod terminal;

pub use folder::ReportFolder;
