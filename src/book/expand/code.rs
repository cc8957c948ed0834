//! Anchors before the Rust blocks of statements, so that the evidence can link to the very example.

use std::ops::Range;

use super::Expansion;

impl Expansion<'_> {
    /// Adds an anchor before each Rust block of a statement.
    pub(super) fn code_anchors(&self, edits: &mut Vec<(Range<usize>, String)>) {
        if self.repeated {
            return;
        }
        for statement in &self.page.statements {
            for &index in &statement.code {
                let block = &self.page.code[index];
                let starts_line = self.page.text[..block.span.start].ends_with('\n');
                if block.is_rust() && starts_line {
                    let anchor = code_anchor(&statement.id, block.line - statement.line);
                    edits.push((
                        block.span.start..block.span.start,
                        format!("\n<div class=\"anchor\" id=\"{anchor}\"></div>\n\n"),
                    ));
                }
            }
        }
    }
}

/// The anchor of the block that opens `lines` lines below its statement.
pub(crate) fn code_anchor(id: &str, lines: usize) -> String {
    format!("{id}--code-{lines}")
}
