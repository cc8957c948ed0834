//! Figures of the section on affine maps.

use cagd::affine::{Affine, AffineBasis, AffineMap, Point, figures, signed_area};
use cagd::figure::{BoxError, Place, Plot};

use crate::support::{Checked, ensure, figure_test, near};

type Map = AffineMap<f64, 2, 2>;

/// Some ten roundings of numbers below 10, in maps with entries below 4 that are solved for in units of at least 1/10.
const BOUND: f64 = 1e-13;

fn close(what: &str, found: f64, expected: f64) -> Checked {
    ensure((found - expected).abs() <= BOUND, || {
        format!("{what}: found {found}, expected {expected}")
    })
}

/// The affine map that takes the plotted letter of a panel to its plotted image.
fn plotted_map(plot: &Plot, panel: &str) -> Result<Map, BoxError> {
    let letter = plot.polygon(&format!("{panel}/letter"))?;
    let image = plot.polygon(&format!("{panel}/image"))?;
    let [foot, side, top] = [0, 1, 9];
    let basis = AffineBasis::new([foot, side, top].map(|i| letter[i]))?;
    let map = AffineMap::from_images(&basis, &[foot, side, top].map(|i| image[i]))?;
    for (point, image) in std::iter::zip(letter, image) {
        near(panel, map.point(point), *image, BOUND)?;
    }
    Ok(map)
}

/// Each image is an affine one of the letter, of the kind that its panel names.
#[test]
fn map_examples() {
    figure_test(figures::map_examples(), |plot| {
        let entry = |map: &Map, row: usize, column: usize| map.linear()[(row, column)];
        let origin = Point::origin();

        let translation = plotted_map(plot, "translation")?;
        let [_, tip] = plot.segment("translation/v")?;
        near(
            "the origin moves by v",
            translation.point(&origin),
            tip,
            BOUND,
        )?;
        close("translation", entry(&translation, 0, 0), 1.0)?;
        close("translation", entry(&translation, 0, 1), 0.0)?;

        let scaling = plotted_map(plot, "scaling")?;
        close("scaling", entry(&scaling, 0, 1), 0.0)?;
        close("scaling", entry(&scaling, 1, 0), 0.0)?;

        let homothety = plotted_map(plot, "homothety")?;
        let centre = plot.point("homothety/centre")?;
        near("the centre stays", homothety.point(&centre), centre, BOUND)?;
        close(
            "one factor",
            entry(&homothety, 0, 0),
            entry(&homothety, 1, 1),
        )?;
        close("homothety", entry(&homothety, 0, 1), 0.0)?;

        let rotation = plotted_map(plot, "rotation")?;
        close("the determinant of a rotation", rotation.determinant(), 1.0)?;
        close("rotation", entry(&rotation, 0, 0), entry(&rotation, 1, 1))?;

        let shear = plotted_map(plot, "shear")?;
        close("the determinant of a shear", shear.determinant(), 1.0)?;
        close("heights stay", entry(&shear, 1, 0), 0.0)?;

        let projection = plotted_map(plot, "projection")?;
        close("a projection is flat", projection.determinant(), 0.0)?;
        let [_, w] = plot.segment("projection/w")?;
        near("w goes to 0", projection.point(&w), origin, BOUND)?;
        let on_axis = plot.polygon("projection/image")?.iter().map(|p| p[1].abs());
        close("the image is on the axis", on_axis.fold(0.0, f64::max), 0.0)
    })
    .rejects("an image that no affine map gives", |plot| {
        let mut corners = plot.polygon("scaling/image")?.to_vec();
        corners[5] = Point::origin();
        plot.replaced("scaling/image", corners)
    })
    .rejects("another translation", |plot| {
        plot.shifted("translation/image", [0.2, 0.0])
    })
    .rejects("a scaling for a rotation", |plot| {
        plot.swapped("rotation/image", "scaling/image")
    })
    .rejects("a homothety from the origin", |plot| {
        plot.shifted("homothety/centre", [0.3, 0.0])
    })
    .rejects("a projection onto another line", |plot| {
        plot.shifted("projection/image", [0.0, 0.5])
    })
    .snapshot();
}

/// The images are on the line and on the rays, and M' is not in the middle.
#[test]
fn central_projection_not_affine() {
    figure_test(figures::central_projection_not_affine(), |plot| {
        let [a, b] = plot.segment("AB")?;
        near("M", plot.point("M")?, a.lerp(&b, 0.5), BOUND)?;
        let centre = plot.point("O")?;
        let [on_line, _] = plot.segment("image line")?;
        let labels: Vec<(&str, Place)> = plot.labels().collect();
        let labelled = |name: &str| {
            let found = labels.iter().find(|(text, _)| *text == name);
            found.map_or(centre, |(_, place)| *place)
        };
        let ends = plot.points("images of the ends")?;
        near("A'", ends[0], labelled("A'"), BOUND)?;
        near("B'", ends[1], labelled("B'"), BOUND)?;
        for (name, point) in [("A'", a), ("B'", b), ("M'", plot.point("M")?)] {
            let image = labelled(name);
            close("a ray", signed_area(&centre, &point, &image), 0.0)?;
            close("the height of an image", image[1], on_line[1])?;
        }
        let image = plot.point("image of M")?;
        near("the image of M", image, labelled("M'"), BOUND)?;
        let middle = plot.point("midpoint of the images")?;
        let expected = labelled("A'").lerp(&labelled("B'"), 0.5);
        near("the midpoint of the images", middle, expected, BOUND)?;
        near(
            "2/3 and 1/2",
            image,
            middle.translated(&[1.0 / 6.0, 0.0].into()),
            BOUND,
        )
    })
    .rejects("an image beside its ray", |plot| {
        plot.shifted("image of M", [0.1, 0.0])
    })
    .rejects("an image in the middle", |plot| {
        plot.replaced("image of M", [plot.point("midpoint of the images")?])
    })
    .rejects("another segment", |plot| plot.shifted("AB", [0.1, 0.2]))
    .snapshot();
}

/// One affine map takes the corners, M and D to their images; D is on BC, and the text has the coordinates of M.
#[test]
fn exercise_image_of_points() {
    figure_test(figures::exercise_image_of_points(), |plot| {
        let corners = plot.polygon("ABC")?;
        let images = plot.polygon("image of ABC")?;
        let basis = AffineBasis::new(corners.iter().copied())?;
        let map = AffineMap::from_images(&basis, images)?;
        let (m, d) = (plot.point("M")?, plot.point("D")?);
        near("T(M)", map.point(&m), plot.point("T(M)")?, BOUND)?;
        near("T(D)", map.point(&d), plot.point("D'")?, BOUND)?;
        close("D on BC", signed_area(&corners[1], &corners[2], &d), 0.0)?;
        close("D on AM", signed_area(&corners[0], &m, &d), 0.0)?;
        let text = plot.text("coordinates")?;
        let weights = basis.coordinates(&m);
        let expected = format!(
            "M = {:.1}A + {:.1}B + {:.1}C",
            weights[0], weights[1], weights[2]
        );
        ensure(text == expected, || format!("{text} should be {expected}"))
    })
    .rejects("another image of M", |plot| {
        plot.shifted("T(M)", [0.1, 0.0])
    })
    .rejects("D beside the side", |plot| plot.shifted("D", [0.1, 0.0]))
    .rejects("the images exchanged", |plot| {
        let images = plot.polygon("image of ABC")?;
        plot.replaced("image of ABC", [images[1], images[0], images[2]])
    })
    .rejects("other coordinates", |plot| {
        plot.rewritten("coordinates", "M = 0.4A + 0.3B + 0.3C")
    })
    .snapshot();
}

/// One affine map takes the grid, the circle and the divided segment to their images; the rows stay parallel.
#[test]
fn map_properties() {
    figure_test(figures::map_properties(), |plot| {
        let basis = AffineBasis::new(plot.polygon("grid/cell")?[..3].iter().copied())?;
        let map = AffineMap::from_images(&basis, &plot.polygon("image/cell")?[..3])?;
        for family in ["row", "column"] {
            let [first, last] = plot.segment(&format!("image/{family} 0"))?;
            for k in 0..=4 {
                let ends = plot.segment(&format!("grid/{family} {k}"))?;
                let images = plot.segment(&format!("image/{family} {k}"))?;
                for (end, image) in std::iter::zip(ends, images) {
                    near(family, map.point(&end), image, BOUND)?;
                }
                near("parallels", first + (images[1] - images[0]), last, BOUND)?;
            }
        }
        let circles = [
            plot.polyline("grid/circle")?,
            plot.polyline("image/circle")?,
        ];
        for (point, image) in std::iter::zip(circles[0], circles[1]) {
            near("the ellipse", map.point(point), *image, BOUND)?;
        }
        let [p, q] = plot.segment("image/PQ")?;
        let r = plot.point("image/R")?;
        near("R divides PQ", p.lerp(&q, 0.3), r, BOUND)?;
        let lengths = [plot.segment("grid/PQ")?, plot.segment("image/PQ")?]
            .map(|[from, to]| (to - from).norm());
        ensure((lengths[0] - lengths[1]).abs() > 0.1, || {
            "the length has not changed".into()
        })
    })
    .rejects("a row that is not parallel", |plot| {
        let [from, to] = plot.segment("image/row 2")?;
        plot.replaced("image/row 2", [from, Point::new([to[0], to[1] + 0.2])])
    })
    .rejects("another ratio", |plot| plot.shifted("image/R", [0.1, -0.1]))
    .rejects("a circle for the ellipse", |plot| {
        plot.replaced("image/circle", plot.polyline("grid/circle")?.to_vec())
    })
    .snapshot();
}

/// The parallelogram has the base and the height of the square, its area is 1 and so says the text.
#[test]
fn figure_shear() {
    figure_test(figures::figure_shear(), |plot| {
        let (square, image) = (plot.polygon("square")?, plot.polygon("image")?);
        for (point, image) in std::iter::zip(square, image) {
            close("heights stay", image[1], point[1])?;
        }
        near("the base stays", image[1], square[1], BOUND)?;
        near("the base stays", image[0], square[0], BOUND)?;
        let [from, to] = plot.segment("shift")?;
        near(
            "the corner moves along the arrow",
            square[3] + (to - from),
            image[3],
            BOUND,
        )?;
        let area = signed_area(&image[0], &image[1], &image[2])
            + signed_area(&image[0], &image[2], &image[3]);
        close("the area", area, 1.0)?;
        let text = plot.text("area")?;
        ensure(text == "\\text{area} = 1", || {
            format!("the text says {text}")
        })
    })
    .rejects("a larger parallelogram", |plot| plot.scaled("image", 1.1))
    .rejects("another shift", |plot| {
        plot.shifted("shift", [0.1, 0.0]).and_then(|plot| {
            let [from, to] = plot.segment("shift")?;
            plot.replaced("shift", [from, Point::new([to[0] + 0.3, to[1]])])
        })
    })
    .rejects("another area", |plot| {
        plot.rewritten("area", "\\text{area} = 0.8")
    })
    .snapshot();
}
