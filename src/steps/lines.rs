//! The lines of a printed text, each with its origin.

use std::collections::HashMap;
use std::fmt;

use super::amend::{Amendment, Scope, Spelling, Statement};
use super::origin::Origin;

/// A line of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextLine {
    /// The line, with its indentation.
    pub text: String,
    /// Where it comes from. Every line that is no note has an origin.
    pub origin: Option<Origin>,
    /// Where the text is from that it belongs to: paper, section, listing.
    pub source: &'static str,
    /// Its number among the printed lines of that source.
    pub number: Option<u32>,
    /// Whether it is a remark of this edition: a quotation, a reason, a title. No machine sees it.
    pub note: bool,
    /// Whether a statement begins with it. One that runs another text begins with the remark that has its title, and one
    /// that is left open in this reading with the remark that says so.
    pub begins: bool,
}

/// Lines, one after the other.
pub(super) fn text(lines: &[TextLine]) -> String {
    lines
        .iter()
        .map(|line| format!("{}\n", line.text))
        .collect()
}

/// Lines as they are printed.
pub(super) struct Lines {
    done: Vec<TextLine>,
    /// The source of what is printed.
    pub(super) source: &'static str,
    numbers: HashMap<&'static str, u32>,
    told: Vec<Origin>,
}

impl Lines {
    pub(super) fn of(source: &'static str) -> Self {
        Self {
            done: Vec::new(),
            source,
            numbers: HashMap::new(),
            told: Vec::new(),
        }
    }

    pub(super) fn done(self) -> Vec<TextLine> {
        self.done
    }

    /// The first lines of a statement, in the paper's own spelling if it has one. `lead` stands before each.
    pub(super) fn statement<S: Statement>(
        &mut self,
        lead: &str,
        text: impl fmt::Display,
        scope: Scope<'_, S>,
    ) {
        let first = self.done.len();
        self.spelt(lead, text, scope.origin(), scope.spelling());
        // Remarks on its origin stand before it.
        let mut lines = self.done[first..].iter_mut();
        if let Some(line) = lines.find(|line| !line.note) {
            line.begins = true;
        }
    }

    /// A line of a statement that is not its first.
    pub(super) fn rest<S: Statement>(
        &mut self,
        lead: &str,
        text: impl fmt::Display,
        scope: Scope<'_, S>,
    ) {
        self.spelt(lead, text, scope.origin(), None);
    }

    /// A remark.
    pub(super) fn note(&mut self, lead: &str, text: impl fmt::Display, origin: Option<Origin>) {
        self.done.push(TextLine {
            text: format!("{}// {text}", blank(lead)),
            origin,
            source: self.source,
            number: None,
            note: true,
            begins: false,
        });
    }

    /// A remark in the place of a statement.
    pub(super) fn stand_in(&mut self, lead: &str, text: impl fmt::Display, origin: Option<Origin>) {
        self.note(lead, text, origin);
        if let Some(line) = self.done.last_mut() {
            line.begins = true;
        }
    }

    /// The reason of an amendment.
    pub(super) fn amendment<S>(&mut self, lead: &str, amendment: &Amendment<S>) {
        let origin = amendment.origin();
        let (key, place, why) = (amendment.key, amendment.place, amendment.why);
        if let Origin::Silence { .. } = origin {
            let text = format!(
                "the paper does not say: {place} (filled by {key} in the reading as-printed, because {why})"
            );
            return self.stand_in(lead, text, Some(origin));
        }
        self.note(lead, format_args!("{key}: {why}"), Some(origin));
        match origin {
            Origin::Filling { rests_on, .. } => self.note(lead, rests_on, Some(origin)),
            Origin::Prose { quote } => self.note(lead, format_args!("\"{quote}\""), Some(origin)),
            _ => {}
        }
        self.told.push(origin);
    }

    fn spelt(
        &mut self,
        lead: &str,
        text: impl fmt::Display,
        origin: Option<Origin>,
        spelling: Option<Spelling>,
    ) {
        if let Some(origin) = origin {
            self.tell(lead, origin);
        }
        let text = spelling.map_or_else(|| text.to_string(), |spelling| spelling.text.into());
        for line in text.split('\n') {
            let number = (origin == Some(Origin::Printed)).then(|| self.number());
            self.done.push(TextLine {
                text: format!("{lead}{line}").trim_end().to_owned(),
                origin,
                source: self.source,
                number,
                note: false,
                begins: false,
            });
        }
        if let Some(meaning) = spelling.and_then(|spelling| spelling.meaning) {
            self.note(lead, format_args!("OpenGL's name is {meaning}"), None);
        }
    }

    /// A sentence or a reason is told once.
    fn tell(&mut self, lead: &str, origin: Origin) {
        if self.told.contains(&origin) {
            return;
        }
        self.told.push(origin);
        match origin {
            Origin::Prose { quote } => self.note(lead, format_args!("\"{quote}\""), Some(origin)),
            Origin::Edition { why } => self.note(lead, why, Some(origin)),
            Origin::Printed
            | Origin::Silence { .. }
            | Origin::Filling { .. }
            | Origin::Amendment { .. } => {}
        }
    }

    fn number(&mut self) -> u32 {
        let number = self.numbers.entry(self.source).or_default();
        *number += 1;
        *number
    }
}

/// As much space as the lead takes.
fn blank(lead: &str) -> String {
    lead.chars().map(|_| ' ').collect()
}
