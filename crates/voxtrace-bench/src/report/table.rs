//! A table, as Markdown and as HTML.

/// Lines of cells; columns but the first `left` are numbers. `**strong**` in a cell is Markdown's.
pub struct Table {
    pub head: Vec<&'static str>,
    pub left: usize,
    pub lines: Vec<Vec<String>>,
}

impl Table {
    pub fn new(head: &[&'static str], left: usize, lines: Vec<Vec<String>>) -> Self {
        Self { head: head.to_vec(), left, lines }
    }

    pub fn markdown(&self) -> String {
        let rule = (0..self.head.len()).map(|i| if i < self.left { "---" } else { "---:" }).collect::<Vec<_>>();
        let mut text = format!("| {} |\n|{}|\n", self.head.join(" | "), rule.join("|"));
        for line in &self.lines {
            let cells: Vec<String> = line.iter().map(|cell| cell.replace('|', "/").replace('\n', " ")).collect();
            text += &format!("| {} |\n", cells.join(" | "));
        }
        text
    }

    /// In a box of its own, so that a wide table scrolls and the page does not.
    pub fn html(&self) -> String {
        let class = |column: usize| if column < self.left { "" } else { " class=\"n\"" };
        let row = |tag: &str, cells: &mut dyn Iterator<Item = String>| {
            let cells = cells.enumerate().map(|(column, cell)| format!("<{tag}{}>{cell}</{tag}>", class(column)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        let head = row("th", &mut self.head.iter().map(|cell| escape(cell)));
        let body = self.lines.iter().map(|line| row("td", &mut line.iter().map(|cell| strong(&escape(cell)))));
        let body: String = body.collect();
        format!(
            "<div class=\"scroll\" tabindex=\"0\"><table><thead>{head}</thead><tbody>\n{body}</tbody></table></div>\n"
        )
    }
}

/// Text that may stand in HTML and SVG, in attributes too.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            control if control.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}

fn strong(text: &str) -> String {
    let mut is_open = false;
    let mut parts = text.split("**");
    let mut html = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        is_open = !is_open;
        html += if is_open { "<strong>" } else { "</strong>" };
        html += part;
    }
    html + if is_open { "</strong>" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_file_name_holds_cannot_become_markup() {
        let lines =
            vec![vec!["<script>alert(1)</script>".into(), "a|b\n".into()], vec!["**no** (2)".into(), "1".into()]];
        let table = Table::new(&["scene", "n"], 1, lines);
        let html = table.html();
        assert!(!html.contains("<script") && html.contains("&lt;script&gt;"), "{html}");
        assert!(html.contains("<td><strong>no</strong> (2)</td><td class=\"n\">1</td>"), "{html}");
        assert_eq!(table.markdown().lines().count(), 4);
        assert!(table.markdown().starts_with("| scene | n |\n|---|---:|\n"));
        assert_eq!(escape("\"'\u{7}&"), "&quot;&#39; &amp;");
    }
}
