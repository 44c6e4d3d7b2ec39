//! Playing a benchmark plan: a TOML as `voxtrace bench --plan` reads it, and the folder of the report.

use super::PathField;
use crate::running::RunRequest;
use crate::session::Session;
use crate::tr;
use std::path::PathBuf;

/// What somebody has chosen.
#[derive(Clone, Debug)]
pub struct PlanDialog {
    /// The plan.
    pub plan: PathField,
    /// The folder of the report.
    pub folder: PathField,
    /// Fewer frames, and no sweep: minutes in place of hours.
    pub quick: bool,
    /// The plan that the folder was named after.
    named_after: String,
}

impl PlanDialog {
    /// Begins in the usual folder.
    pub fn new(session: &Session) -> Self {
        let folder = session.usual_folder();
        Self {
            plan: PathField::of_ending(&folder.join(""), ".toml"),
            folder: PathField::new(&folder.join("voxtrace-bench")),
            quick: true,
            named_after: String::new(),
        }
    }

    /// Names the folder after the plan, where that is another one.
    pub fn name_folder(&mut self) {
        if self.plan.text == self.named_after {
            return;
        }
        self.named_after.clone_from(&self.plan.text);
        let Some(plan) = self.plan.path().filter(|plan| plan.is_file()) else { return };
        let stem = plan.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        self.folder.set(&plan.with_file_name(format!("{stem}-report")).display().to_string());
        self.folder.is_settled = true;
    }

    /// The command that plays it.
    ///
    /// # Errors
    /// One line: what is missing yet.
    pub fn request(&self) -> Result<RunRequest, String> {
        let absolute = |path: PathBuf| std::path::absolute(&path).unwrap_or(path);
        let plan = self.plan.path().map(absolute).ok_or(tr!("dialogs_plan.name_plan"))?;
        if !plan.is_file() {
            return Err(tr!("dialogs_plan.no_plan").into());
        }
        let folder = self.folder.path().map(absolute).ok_or(tr!("dialogs_plan.name_folder"))?;
        if folder.is_file() {
            return Err(tr!("dialogs.folder_is_file").into());
        }
        let text = |path: &PathBuf| path.to_str().map(str::to_owned).ok_or(tr!("dialogs_plan.no_unicode"));
        let mut words = ["voxtrace", "bench", "--plan"].map(str::to_owned).to_vec();
        words.extend([text(&plan)?, "--output".into(), text(&folder)?]);
        words.extend(self.quick.then(|| "--quick".to_owned()));
        let name = folder.join("report.html").display().to_string();
        Ok(RunRequest { words, name, folders: Vec::new(), measures: true })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_names_its_report_and_is_played_by_bench() {
        let folder = tempfile::tempdir().unwrap();
        let plan = folder.path().join("work.toml");
        let mut dialog = PlanDialog::new(&Session::new(voxtrace_vulkan::Traversal::Cpu));
        dialog.plan = PathField::new(&plan);
        assert_eq!(dialog.request().unwrap_err(), tr!("dialogs_plan.no_plan"));
        std::fs::write(&plan, "").unwrap();
        dialog.name_folder();
        let request = dialog.request().unwrap();
        let report = folder.path().join("work-report");
        assert_eq!(request.name, report.join("report.html").display().to_string());
        let words =
            ["voxtrace", "bench", "--plan", plan.to_str().unwrap(), "--output", report.to_str().unwrap(), "--quick"];
        assert_eq!(request.words, words);
        assert!(request.measures);
    }
}
