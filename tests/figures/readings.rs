//! What stands beside a live figure: the laws, for the values that a reader chose, and why a position is special.

use std::collections::BTreeMap;

use cagd::figure::{Figure, LawReading, ParameterKind, Plot};
use cagd::gallery;

/// Live figures without a law, since what they show is no equation or inequality.
const WITHOUT_LAW: [&str; 4] = [
    // Two sets of coefficients of one cubic, compared by eye.
    "bezier-motivation",
    // What a curve does not do, which is seen.
    "bezier-disadvantages",
    // That ratios are not kept: a law would have to fail.
    "affine-central-projection-not-affine",
    // A definition, with a set of either kind.
    "affine-figure-convex",
];

fn with_laws() -> Vec<Figure> {
    let is_live = |figure: &Figure| !figure.parameters().is_empty();
    gallery::all()
        .into_iter()
        .filter(|figure| is_live(figure) && !WITHOUT_LAW.contains(&figure.id()))
        .collect()
}

/// A number in [0, 1) that depends on the seed alone; the step is that of `numerical recipes`, §7.1.
fn chance(seed: &mut u64) -> f64 {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// Values as a reader could drag them: handles around where they were, sliders anywhere.
fn dragged(figure: &Figure, seed: &mut u64) -> String {
    let mut near = |x: f64| (4.0 * (x + 6.0 * chance(seed) - 3.0)).round() / 4.0 + 0.1;
    let mut parts = vec![];
    for parameter in figure.parameters() {
        let value = match &parameter.kind {
            ParameterKind::Handles { defaults, .. } => defaults
                .iter()
                .map(|p| format!("{},{}", near(p[0]), near(p[1])))
                .collect::<Vec<_>>()
                .join(";"),
            ParameterKind::Handle { default, .. } => {
                format!("{},{}", near(default[0]), near(default[1]))
            }
            ParameterKind::Slider { low, high, .. } => (low
                + (high - low) * (near(0.0) + 2.9) / 6.0)
                .clamp(*low, *high)
                .to_string(),
            ParameterKind::Stepper { low, high, .. } => {
                let share = (near(0.0) + 2.9) / 6.0;
                (low + ((high - low) as f64 * share.clamp(0.0, 1.0)) as usize).to_string()
            }
        };
        parts.push(format!("{}={value}", parameter.name));
    }
    parts.join("&")
}

fn figure(id: &str) -> Figure {
    gallery::find(id).unwrap_or_else(|| panic!("no figure {id}"))
}

fn plotted(figure: &Figure, text: &str) -> Plot {
    let values = figure
        .values(text)
        .unwrap_or_else(|e| panic!("{}: {text}: {e}", figure.id()));
    figure
        .plot(&values)
        .unwrap_or_else(|e| panic!("{}: {text}: {e}", figure.id()))
}

#[test]
fn every_live_figure_shows_its_law_and_the_law_holds() {
    for figure in with_laws() {
        let plot = plotted(&figure, "");
        let readings = plot.readings();
        assert!(!readings.is_empty(), "{} shows no law", figure.id());
        for reading in readings {
            assert!(reading.holds, "{}: {reading:?}", figure.id());
            assert!(!reading.left.is_empty(), "{}: {reading:?}", figure.id());
        }
    }
}

#[test]
fn the_laws_hold_wherever_a_reader_drags() {
    let mut seed = 1;
    let mut inequalities = 0;
    for figure in with_laws() {
        for _ in 0..40 {
            let text = dragged(&figure, &mut seed);
            for reading in plotted(&figure, &text).readings() {
                assert!(reading.holds, "{} at {text}: {reading:?}", figure.id());
                inequalities += usize::from(reading.residual < 0.0);
            }
        }
    }
    // Inequalities that hold with room say that the sides are numbers and not twice the same.
    assert!(inequalities > 100, "{inequalities}");
}

/// The readings of a figure as they stand on the page.
fn written(plot: &Plot) -> Vec<String> {
    let line = |r: &LawReading| format!("{}: {} {} {}", r.claim, r.left, r.relation, r.right);
    plot.readings().iter().map(line).collect()
}

#[test]
fn the_sides_are_those_of_the_default_picture() {
    let lines = |id: &str| written(&plotted(&figure(id), ""));
    assert_eq!(
        lines("bezier-bernstein-polynomials")[1],
        "they sum to 1: 1 = 1"
    );
    assert_eq!(
        lines("bezier-de-casteljau-triangle")[3],
        "column 3 combines its neighbours with weights 1 − t and t: 1.904, 2.16 = 1.904, 2.16"
    );
    assert_eq!(
        lines("affine-figure-triangle-area")[0].split(": ").last(),
        Some("3.24 = 3.24")
    );
    assert_eq!(
        lines("affine-figure-pick"),
        ["the area is I + R/2 − 1: 2.5 = 2.5"]
    );
}

/// Positions in which the hypothesis of a figure does not hold, each with words of the sentence that the figure says then.
const SPECIAL: &str = "
bezier-bernstein-polynomials            | t=0                           | 0 < t < 1
bezier-unimodal                         | m=1                           | at an end
bezier-blossom-de-casteljau             | t=1                           | length 0
bezier-chord-bound                      | b=0,0;1,1;2,2;3,3             | second differences are 0
bezier-chord-bound                      | b=0,0;1,1;2,2;0,0             | ends where it starts
bezier-control-polygon-bound            | b=0,0;0,1;0,2;0,3;0,4         | second differences are 0
bezier-intersection-algorithm           | q=0,1;3,8;6,-3;9,4.5          | finitely many
bezier-intersection-algorithm           | q=0,11;3,18;6,13;9,14         | do not meet
bezier-figure-de-casteljau              | t=0                           | first control point
bezier-parameter-range                  | t=-0.2                        | negative
bezier-parameter-range                  | t=1                           | last control point
bezier-de-casteljau-triangle            | t=1                           | last control point
bezier-derivative-consequences          | t=0&b=0,0;0,0;1,1;2,0         | b′(t) ≠ 0
bezier-end-curvature                    | b=0,0;0,0;1,1;2,0             | b₀ ≠ b₁
bezier-end-curvature                    | b=0,0;1,0;2,0;2,2             | no circle
bezier-quadratic-parabola               | b=0,0;3,0;1,0                 | to and fro
bezier-quadratic-parabola               | b=0,0;1,0;2,0                 | segment remains
bezier-bernstein-approximation          | m=1                           | chord
bezier-disadvantages                    | c=7,4                         | the same
bezier-de-casteljau-path-counting       | n=2&k=3                       | at most n
bezier-de-casteljau-path-counting       | n=3&k=0                       | single path
bezier-polynomial-curve-smooth          | t=0.5                         | turn sharply
bezier-centre-of-gravity                | t=1                           | whole mass
bezier-figure-convex-hull               | b=0,0;1,1;2,2;3,3;1,1         | segment
bezier-figure-affine-invariance         | m_11=0&m_12=0                 | determinant is 0
bezier-line-intersections               | p=1,1&q=1,1                   | no line
bezier-line-intersections               | b=0,0;1,0;2,0;3,0&p=0,0&q=1,0 | not in the line
bezier-variation-diminishing            | p=1,1&q=1,1                   | no line
bezier-figure-subdivision               | alpha=0                       | 0 < α < 1
affine-figure-triangle-area             | R=0,0&P=1,1&Q=2,2             | determinant is 0
affine-figure-pick                      | P=0,0;1,1;2,2                 | an inside
affine-barycentric-in-triangle          | A=0,0&B=1,1&C=2,2             | not on a line
affine-barycentric-in-triangle          | G=9,9                         | negative
affine-exercise-points-on-line          | A=1,1&B=1,1                   | A ≠ B
affine-figure-combinations              | a=1,1&b=2,2                   | linearly dependent
affine-barycentre                       | w_0=0&w_1=0&w_2=0             | another sum
affine-barycentre                       | w_0=0                         | no part
affine-map-examples                     | w=1,0                         | no projection
affine-central-projection-not-affine    | A=1,0                         | no image
affine-central-projection-not-affine    | A=0,2&B=2,2                   | parallel
affine-exercise-image-of-points         | A=0,0&B=1,1&C=2,2             | not determined
affine-map-properties                   | O'=0,0&E_1'=1,1&E_2'=2,2      | areas become 0
affine-map-properties                   | P=1,1&Q=1,1                   | no ratio
affine-figure-shear                     | a=0                           | identity
subdivision-figure-half-edge            | h=15                          | no face
subdivision-figure-four-point           | w=0                           | middle of its leg
subdivision-four-point-tension          | w=0                           | middle of its leg
subdivision-four-point-tension          | w=0.2                         | not C¹
subdivision-four-point-analysis         | w=0.1                         | two factors
subdivision-creases                     | top=0                         | No edge is sharp
subdivision-creases                     | bottom=1&sides=1&top=1        | the cube remains
subdivision-characteristic-map          | scheme=5&k=9                  | covers itself
";

/// Figures with points that may all lie in one place, and words of what they say then.
const IN_ONE_PLACE: &str = "
bezier-uniform-convergence              | second differences are 0
bezier-motivation                       | in one place
bezier-de-casteljau-worked-example      | b′(t) ≠ 0
bezier-quadratic-parabola               | in one place
bezier-degree-elevation                 | in one place
bezier-figure-convex-hull               | this point
bezier-figure-corner-cutting            | length 0
bezier-corner-cutting-convergence       | length 0
affine-barycentric-on-line              | A ≠ B
subdivision-approximating-interpolating | in one place
subdivision-figure-chaikin              | in one place
subdivision-chaikin-convergence         | in one place
subdivision-figure-lane-riesenfeld      | in one place
subdivision-cubic-curve                 | in one place
subdivision-limit-stencils              | in one place
subdivision-figure-four-point           | in one place
subdivision-figure-precision            | no line
";

/// The cells of a table, line by line.
fn rows<const CELLS: usize>(table: &str) -> Vec<[&str; CELLS]> {
    let lines = table.trim().lines();
    let rows = lines.map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let row = cells.try_into();
        row.unwrap_or_else(|cells: Vec<&str>| panic!("{CELLS} cells are needed: {cells:?}"))
    });
    rows.collect()
}

/// In this position the figure says so, and its laws hold.
fn assert_says(figure: &Figure, text: &str, expected: &str) {
    let id = figure.id();
    let plot = plotted(figure, text);
    let said = plot.remarks().join(" ");
    assert!(said.contains(expected), "{id} at {text} says: {said}");
    for reading in plot.readings() {
        assert!(reading.holds, "{id} at {text}: {reading:?}");
    }
}

#[test]
fn a_degenerate_position_says_what_the_hypothesis_was_for() {
    for [id, text, expected] in rows(SPECIAL) {
        assert_says(&figure(id), text, expected);
    }
}

#[test]
fn points_in_one_place_are_remarked_on() {
    for [id, expected] in rows(IN_ONE_PLACE) {
        let figure = figure(id);
        let mut parameters = figure.parameters().iter();
        let points = parameters.find_map(|parameter| match &parameter.kind {
            ParameterKind::Handles { defaults, .. } => Some((&parameter.name, defaults.len())),
            _ => None,
        });
        let (name, count) = points.unwrap_or_else(|| panic!("{id} has no list of points"));
        let text = format!("{name}={}", vec!["1,1"; count].join(";"));
        assert_says(&figure, &text, expected);
    }
}

/// A remark is for what is special; where the default position is special itself, it is the theme of the figure.
#[test]
fn a_general_position_needs_no_remark() {
    const SPECIAL_BY_DEFAULT: [&str; 1] = ["bezier-parameter-range"];
    let mut remarks: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for figure in gallery::all() {
        let plot = plotted(&figure, "");
        if !plot.remarks().is_empty() && !SPECIAL_BY_DEFAULT.contains(&figure.id()) {
            remarks.insert(figure.id().to_owned(), plot.remarks().to_vec());
        }
    }
    assert!(remarks.is_empty(), "{remarks:#?}");
}
