//! What holds for every figure of the book.

use std::collections::BTreeSet;

use cagd::figure::{Figure, ParameterKind};
use cagd::gallery;

use crate::support::snapshots;

/// The largest picture allowed, in bytes.
///
/// A chapter of 40 such figures stays below 2.4 MB before compression; typical figures have 6 kB.
const LARGEST: usize = 60_000;

/// Runs a check on every figure and reports all failures at once.
#[track_caller]
fn each(check: impl Fn(&Figure) -> Result<(), String>) {
    let failures: Vec<String> = gallery::all()
        .iter()
        .filter_map(|figure| {
            check(figure)
                .err()
                .map(|why| format!("{}: {why}", figure.id()))
        })
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

fn well_formed(svg: &str) -> Result<(), String> {
    let document = roxmltree::Document::parse(svg).map_err(|e| format!("not well-formed: {e}"))?;
    let coordinate = |name: &str| matches!(name, "d" | "x" | "y" | "cx" | "cy" | "r" | "dx" | "dy");
    for attribute in document.descendants().flat_map(|node| node.attributes()) {
        // Neither path commands nor decimals contain these letters.
        if coordinate(attribute.name()) && attribute.value().contains(['N', 'n', 'i']) {
            return Err(format!(
                "{}=\"{}\" is not a number",
                attribute.name(),
                attribute.value()
            ));
        }
    }
    let root = document.root_element();
    for (name, value) in [
        ("role", Some("img")),
        ("viewBox", root.attribute("viewBox")),
    ] {
        if value.is_none() || root.attribute(name) != value {
            return Err(format!("attribute {name} is missing or wrong"));
        }
    }
    let ids: Vec<&str> = document
        .descendants()
        .filter_map(|node| node.attribute("id"))
        .collect();
    if ids.iter().collect::<BTreeSet<_>>().len() != ids.len() {
        return Err(format!("an id is used twice: {ids:?}"));
    }
    let outside = |value: &str| value.contains("url(") || value.contains("//");
    let refers = |node: roxmltree::Node<'_, '_>| {
        node.attributes()
            .any(|attribute| outside(attribute.value()))
    };
    if document.descendants().any(refers) {
        return Err("it refers to something outside".into());
    }
    Ok(())
}

#[test]
fn has_a_title_a_description_and_an_id_of_its_own() {
    let mut seen = BTreeSet::new();
    for figure in gallery::all() {
        assert!(
            !figure.title().trim().is_empty(),
            "{} has no title",
            figure.id()
        );
        // Shorter than this, nothing can be told of what is to be seen.
        assert!(
            figure.description().len() >= 40,
            "the description of {} says too little",
            figure.id()
        );
        assert!(
            seen.insert(figure.id().to_owned()),
            "the id {} is used twice",
            figure.id()
        );
    }
}

#[test]
fn is_a_small_well_formed_picture() {
    each(|figure| {
        let svg = figure.svg().map_err(|e| e.to_string())?;
        well_formed(&svg)?;
        if svg.len() > LARGEST {
            Err(format!("{} bytes are more than {LARGEST}", svg.len()))
        } else {
            Ok(())
        }
    });
    assert!(
        well_formed("<svg><g></svg>").is_err(),
        "the check can refuse"
    );
    assert!(
        well_formed("<svg role=\"img\" viewBox=\"0 0 1 1\"><circle cx=\"NaN\"/></svg>").is_err()
    );
    assert!(
        well_formed("<svg role=\"img\" viewBox=\"0 0 1 1\"><path fill=\"url(#a)\"/></svg>")
            .is_err()
    );
}

#[test]
fn can_be_drawn_at_the_ends_of_every_range() {
    each(|figure| {
        for parameter in figure.parameters() {
            for value in parameter.extremes() {
                let values = figure.defaults().with(&parameter.name, value);
                let plot = figure
                    .plot(&values)
                    .map_err(|e| format!("at {values}: {e}"))?;
                well_formed(&plot.svg()).map_err(|e| format!("at {values}: {e}"))?;
            }
        }
        Ok(())
    });
}

#[test]
fn can_be_drawn_with_all_handles_at_one_place() {
    each(|figure| {
        let mut values = figure.defaults();
        for parameter in figure.parameters() {
            values = match &parameter.kind {
                ParameterKind::Handles { defaults, .. } => {
                    values.with_points(&parameter.name, vec![[0.5, 0.5]; defaults.len()])
                }
                ParameterKind::Handle { .. } => values.with_point(&parameter.name, [0.5, 0.5]),
                ParameterKind::Slider { .. } | ParameterKind::Stepper { .. } => values,
            };
        }
        let plot = figure
            .plot(&values)
            .map_err(|e| format!("at {values}: {e}"))?;
        well_formed(&plot.svg())
    });
}

#[test]
fn has_labels_that_can_be_read() {
    each(|figure| {
        let picture = figure
            .plot(&figure.defaults())
            .map_err(|e| e.to_string())?
            .picture();
        let [width, height] = picture.size;
        for (i, (text, a)) in picture.labels.iter().enumerate() {
            if a[0] < 0.0 || a[1] < 0.0 || a[2] > width || a[3] > height {
                return Err(format!("the label `{text}` leaves the picture: {a:?}"));
            }
            for (other, b) in &picture.labels[..i] {
                if a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3] {
                    return Err(format!("the labels `{text}` and `{other}` overlap"));
                }
            }
        }
        Ok(())
    });
}

#[test]
fn reads_back_the_values_that_it_writes() {
    each(|figure| {
        let defaults = figure.defaults();
        match figure.values(&defaults.to_string()) {
            Ok(values) if values == defaults => Ok(()),
            Ok(values) => Err(format!("{defaults} was read as {values}")),
            Err(error) => Err(error.to_string()),
        }
    });
}

#[test]
fn has_a_reviewed_snapshot_and_no_snapshot_is_left_over() {
    let ids: BTreeSet<String> = gallery::all()
        .iter()
        .map(|figure| figure.id().to_owned())
        .collect();
    let mut folders: BTreeSet<std::path::PathBuf> = ids.iter().map(|id| snapshots(id)).collect();
    folders.insert(snapshots("bezier"));
    let mut found = BTreeSet::new();
    for folder in folders {
        for entry in
            std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        {
            let name = entry
                .expect("a directory entry")
                .file_name()
                .to_string_lossy()
                .into_owned();
            if let Some(id) = name.strip_suffix(".snap.svg") {
                found.insert(id.to_owned());
            }
        }
    }
    let missing: Vec<_> = ids.difference(&found).collect();
    let orphans: Vec<_> = found.difference(&ids).collect();
    assert!(
        missing.is_empty(),
        "without a snapshot, so without a test: {missing:?}"
    );
    assert!(
        orphans.is_empty(),
        "snapshots of no figure, delete them: {orphans:?}"
    );
}
