//! Listings: items of the source code, found by name, as the book shows them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;

use syn::spanned::Spanned;
use syn::{Attribute, ImplItem, Item, TraitItem, Type};

/// The part of a source file that is one item.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Listing {
    /// The code, dedented, with the first line of its documentation.
    pub code: String,
    /// The line of the file in which it begins.
    pub line: usize,
}

/// Finds items in source files, reading and parsing each file once.
#[derive(Debug, Default)]
pub struct Listings {
    files: Mutex<BTreeMap<String, Result<Vec<Found>, String>>>,
}

/// An item of a file.
#[derive(Debug, Clone)]
struct Found {
    name: String,
    /// Whether it is a method of a trait that a type implements.
    of_trait: bool,
    listing: Listing,
}

impl Listings {
    /// The item `item` of the file `path` below `root`.
    ///
    /// An item is named by its name, a method by its type as well: `BezierCurve::at`. Where a type has a method of its
    /// own and one of a trait by the same name, its own is meant.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or is no Rust, an item that is not there, a name that several items share.
    pub fn find(&self, root: &Path, path: &str, item: &str) -> Result<Listing, String> {
        let mut files = self.files.lock().unwrap_or_else(|e| e.into_inner());
        let items = files
            .entry(path.to_owned())
            .or_insert_with(|| {
                let source = std::fs::read_to_string(root.join(path)).map_err(|e| {
                    format!(
                        "the file cannot be read ({e}); the path begins at the root of the package"
                    )
                })?;
                let file = syn::parse_file(&source).map_err(|e| {
                    let line = e.span().start().line;
                    format!("line {line} of the file is no Rust: {e}")
                })?;
                let lines: Vec<&str> = source.lines().collect();
                let mut items = Vec::new();
                collect(&file.items, &lines, &mut items);
                Ok(items)
            })
            .as_ref()
            .map_err(Clone::clone)?;
        let named: Vec<&Found> = items.iter().filter(|found| found.name == item).collect();
        let own: Vec<&&Found> = named.iter().filter(|found| !found.of_trait).collect();
        match (own.as_slice(), named.as_slice()) {
            ([one], _) => Ok(one.listing.clone()),
            ([], [one]) => Ok(one.listing.clone()),
            ([], []) => {
                let names = items.iter().map(|found| found.name.as_str());
                Err(match super::error::most_similar(item, names) {
                    Some(near) => format!("no item is called so; did you mean `{near}`?"),
                    None => "no item is called so; name a function or type, or a method by `Type::method`".to_owned(),
                })
            }
            (several, _) => {
                let several = if several.is_empty() {
                    named.len()
                } else {
                    several.len()
                };
                Err(format!("{several} items are called so; rename all but one"))
            }
        }
    }
}

/// Adds the items of a module.
fn collect(items: &[Item], lines: &[&str], found: &mut Vec<Found>) {
    let mut add = |name: String, of_trait: bool, attributes: &[Attribute], span| {
        let listing = cut(lines, attributes, span);
        found.push(Found {
            name,
            of_trait,
            listing,
        });
    };
    for item in items {
        let span = item.span();
        match item {
            Item::Fn(i) => add(i.sig.ident.to_string(), false, &i.attrs, span),
            Item::Struct(i) => add(i.ident.to_string(), false, &i.attrs, span),
            Item::Enum(i) => add(i.ident.to_string(), false, &i.attrs, span),
            Item::Type(i) => add(i.ident.to_string(), false, &i.attrs, span),
            Item::Const(i) => add(i.ident.to_string(), false, &i.attrs, span),
            Item::Static(i) => add(i.ident.to_string(), false, &i.attrs, span),
            Item::Trait(i) => {
                add(i.ident.to_string(), false, &i.attrs, span);
                for inner in &i.items {
                    if let TraitItem::Fn(method) = inner {
                        let name = format!("{}::{}", i.ident, method.sig.ident);
                        add(name, false, &method.attrs, method.span());
                    }
                }
            }
            Item::Impl(i) => {
                let Type::Path(path) = &*i.self_ty else {
                    continue;
                };
                let Some(segment) = path.path.segments.last() else {
                    continue;
                };
                for inner in &i.items {
                    if let ImplItem::Fn(method) = inner {
                        let name = format!("{}::{}", segment.ident, method.sig.ident);
                        add(name, i.trait_.is_some(), &method.attrs, method.span());
                    }
                }
            }
            _ => {}
        }
    }
    for item in items {
        if let Item::Mod(module) = item
            && let Some((_, items)) = &module.content
        {
            collect(items, lines, found);
        }
    }
}

/// Cuts an item out of its file: all its lines, but only the first of its documentation.
fn cut(lines: &[&str], attributes: &[Attribute], span: proc_macro2::Span) -> Listing {
    let (start, end) = (span.start().line, span.end().line);
    let mut documentation: Vec<usize> = attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("doc"))
        .flat_map(|attribute| attribute.span().start().line..=attribute.span().end().line)
        .collect();
    documentation.sort_unstable();
    let hidden = documentation.get(1..).unwrap_or_default();
    let kept: Vec<&str> = (start..=end)
        .filter(|line| hidden.binary_search(line).is_err())
        .filter_map(|line| lines.get(line - 1).copied())
        .collect();
    let indent = kept
        .iter()
        .filter(|line| !line.trim().is_empty())
        .map(|line| line.len() - line.trim_start().len())
        .min()
        .unwrap_or_default();
    let code: String = kept
        .iter()
        .map(|line| format!("{}\n", line.get(indent..).unwrap_or_default()))
        .collect();
    Listing { code, line: start }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "\
//! A file.

/// Adds.
///
/// At length.
#[inline]
pub fn add(a: u8, b: u8) -> u8 {
    // Why it is so.
    a + b
}

pub struct Curve;

impl Curve {
    /// The degree.
    /// More.
    pub fn degree(&self) -> usize {
        0
    }
}

impl Named for Curve {
    fn degree(&self) -> usize {
        1
    }
    fn name(&self) -> u8 {
        2
    }
}
";

    /// What the listing of `item` shows.
    fn show(item: &str) -> Result<Listing, String> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(folder.path().join("a.rs"), SOURCE).expect("the file is written");
        Listings::default().find(folder.path(), "a.rs", item)
    }

    #[test]
    fn a_function_keeps_comments_and_the_first_line_of_its_documentation() {
        let listing = show("add").expect("it is there");
        let code = "/// Adds.\n#[inline]\npub fn add(a: u8, b: u8) -> u8 {\n    // Why it is so.\n    a + b\n}\n";
        assert_eq!(listing.code, code);
        assert_eq!(listing.line, 3);
    }

    #[test]
    fn a_method_is_dedented_and_found_by_its_type() {
        let code = "/// The degree.\npub fn degree(&self) -> usize {\n    0\n}\n";
        assert_eq!(show("Curve::degree").expect("it is there").code, code);
        assert_eq!(show("Curve::name").expect("it is there").line, 26);
    }

    #[test]
    fn a_missing_item_is_refused_with_a_suggestion() {
        let error = show("Curve::degre").expect_err("there is no such method");
        assert!(error.contains("`Curve::degree`"), "{error}");
    }
}
