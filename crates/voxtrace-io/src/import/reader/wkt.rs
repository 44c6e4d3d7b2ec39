//! Well-known text of reference systems (OGC 12-063r5, section 6): keywords with what stands in their brackets.

/// Deepest nesting and longest text that are read.
const DEEPEST: u32 = 64;
const LONGEST: usize = 1 << 20;

/// A keyword and what belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    /// In capitals.
    pub keyword: String,
    pub items: Vec<Item>,
}

/// What stands in brackets.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    Node(Node),
    /// In quotes, or a bare word.
    Text(String),
    Number(f64),
}

impl Node {
    /// A text as a whole; `None` where it is no WKT.
    pub fn parse(text: &str) -> Option<Self> {
        let mut rest = text.get(..text.len().min(LONGEST))?;
        match item(&mut rest, DEEPEST)? {
            Item::Node(node) => Some(node),
            _ => None,
        }
    }

    /// The nodes among the items.
    pub fn children(&self) -> impl Iterator<Item = &Self> {
        self.items.iter().filter_map(|item| if let Item::Node(node) = item { Some(node) } else { None })
    }

    /// The first node with one of these keywords, itself or within.
    pub fn find(&self, keywords: &[&str]) -> Option<&Self> {
        if keywords.contains(&&*self.keyword) {
            return Some(self);
        }
        self.children().find_map(|child| child.find(keywords))
    }
}

/// Takes an item off the front.
fn item(rest: &mut &str, depth: u32) -> Option<Item> {
    *rest = rest.trim_start();
    if let Some(quoted) = rest.strip_prefix('"') {
        // A quote within is written twice.
        let mut text = String::new();
        let mut quoted = quoted;
        loop {
            let (part, behind) = quoted.split_once('"')?;
            text += part;
            match behind.strip_prefix('"') {
                Some(more) => (text, quoted) = (text + "\"", more),
                None => {
                    *rest = behind;
                    return Some(Item::Text(text));
                }
            }
        }
    }
    let end = rest.find(|c: char| "[](),\"".contains(c) || c.is_whitespace()).unwrap_or(rest.len());
    let (word, behind) = rest.split_at(end);
    *rest = behind.trim_start();
    if !rest.starts_with(['[', '(']) {
        let number = word.parse().ok().filter(|number: &f64| number.is_finite());
        return (!word.is_empty()).then(|| number.map_or(Item::Text(word.into()), Item::Number));
    }
    let depth = depth.checked_sub(1)?;
    *rest = &rest[1..];
    let mut items = Vec::new();
    loop {
        items.push(item(rest, depth)?);
        *rest = rest.trim_start();
        let mut characters = rest.chars();
        let next = characters.next()?;
        *rest = characters.as_str();
        match next {
            ',' => {}
            ']' | ')' => return Some(Item::Node(Node { keyword: word.to_ascii_uppercase(), items })),
            _ => return None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_hold_texts_numbers_and_others() {
        let node = Node::parse(" Unit [ \"a \"\"foot\"\", x\" , 0.3048 , Axis( up ) ] behind").unwrap();
        let axis = Node { keyword: "AXIS".into(), items: vec![Item::Text("up".into())] };
        assert_eq!(node.items, [Item::Text("a \"foot\", x".into()), Item::Number(0.3048), Item::Node(axis)]);
        assert_eq!((node.keyword.as_str(), node.find(&["AXIS"]).is_some()), ("UNIT", true));
    }

    #[test]
    fn what_is_no_text_of_this_kind_is_nothing_however_deep() {
        for wrong in ["", "a", "\"a", "A[", "A[]", "A[1", "[1]x", "A[\"b]"] {
            assert!(Node::parse(wrong).is_none_or(|node| node.keyword.is_empty()), "{wrong}");
        }
        assert!(Node::parse(&"A[".repeat(100_000)).is_none());
        assert!(Node::parse(&("A[".repeat(60) + "1" + &"]".repeat(60))).is_some());
    }
}
