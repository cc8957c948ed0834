//! Figures of the section on affine maps.

use crate::affine::{
    Affine, AffineBasis, AffineMap, CentralProjection, Line, Point, SimplePolygon, Vector, laws,
};
use crate::figure::{BoxError, Canvas, Figure, PointStyle, Side, Style, Values, decimal};

pub(super) fn all() -> Vec<Figure> {
    vec![
        map_examples(),
        central_projection_not_affine(),
        exercise_image_of_points(),
        map_properties(),
        figure_shear(),
    ]
}

type Place = Point<f64, 2>;
type Map = AffineMap<f64, 2, 2>;

/// The corners of a letter F, its foot in the origin.
const LETTER: [[f64; 2]; 10] = [
    [0.0, 0.0],
    [0.6, 0.0],
    [0.6, 1.2],
    [1.4, 1.2],
    [1.4, 1.8],
    [0.6, 1.8],
    [0.6, 2.4],
    [1.8, 2.4],
    [1.8, 3.0],
    [0.0, 3.0],
];

/// A letter F and its images under six affine maps.
#[must_use]
pub fn map_examples() -> Figure {
    Figure::new(
        "affine-map-examples",
        "Six affine images of a letter F",
        "Six panels show the outline of the same letter F, dotted, and a filled image of it: \
         moved by a vector, scaled by different factors along the two axes, scaled from a centre, rotated about the origin, \
         sheared along the horizontal axis, and projected onto the horizontal axis, where only a segment is left of it.",
    )
    .handle_in("translation", "v", [1.4, -0.6])
    .slider("s_1", -1.5..=1.5, 1.4)
    .slider("s_2", -1.5..=1.5, 0.5)
    .handle_in("homothety", "C", [2.6, 0.4])
    .slider("k", -1.5..=1.5, 0.5)
    .slider("\\varphi", -3.0..=3.0, 0.6)
    .slider("a", -1.5..=1.5, 0.5)
    .handle_in("projection", "w", [0.4, -0.7])
    .rows(&[
        &["translation", "scaling"],
        &["homothety", "rotation"],
        &["shear", "projection"],
    ])
    .draw(|values, canvas| {
        let v = values.point("v")?;
        letter(canvas, "translation", &Map::translating(v.from_origin()));
        canvas.arrow("v", [0.0, 0.0], v, Style::Tangent);
        canvas.label("v", v);

        let factors = [values.number("s_1")?, values.number("s_2")?];
        letter(canvas, "scaling", &Map::scaling(factors));

        let centre = values.point("C")?;
        let homothety = Map::homothety(&centre, values.number("k")?);
        letter(canvas, "homothety", &homothety);
        canvas.point("centre", centre, PointStyle::Guide);
        canvas.label("C", centre);

        letter(canvas, "rotation", &Map::rotation(values.number("\\varphi")?));
        letter(canvas, "shear", &Map::shear(values.number("a")?));
        projected(values, canvas)
    })
}

/// The letter and its image in a panel of their own.
fn letter(canvas: &mut Canvas, name: &str, map: &Map) {
    canvas.panel(name);
    canvas.caption(name);
    canvas.window([-1.9, -0.8], [3.4, 3.2]);
    let corners = LETTER.map(Point::new);
    canvas.polygon("letter", corners, Style::Bound);
    canvas.polygon(
        "image",
        corners.each_ref().map(|p| map.point(p)),
        Style::Disc,
    );
    canvas.point("origin", [0.0, 0.0], PointStyle::Guide);
    let corners = [corners[0], corners[1], corners[9]];
    canvas.law(
        "affine-map-properties",
        &laws::volume_factor(AffineMap::determinant, map, &corners),
    );
}

/// The projection onto the first axis along the vector w, if w leaves the axis.
fn projected(values: &Values, canvas: &mut Canvas) -> Result<(), BoxError> {
    let w = values.point("w")?;
    let axis = Line::new([0.0, 1.0], 0.0)?;
    let map = match Map::parallel_projection(&axis, &w.from_origin()) {
        Ok(map) => map,
        Err(_) => {
            canvas.remark("w has the direction of the axis: rays along w never reach it, and there is no projection along w.");
            Map::identity()
        }
    };
    letter(canvas, "projection", &map);
    canvas.line("axis", [0.0, 0.0], [1.0, 0.0], Style::Guide);
    let top = Point::new(LETTER[8]);
    canvas.segment("ray", top, map.point(&top), Style::Guide);
    canvas.arrow("w", [0.0, 0.0], w, Style::Tangent);
    canvas.label("w", w);
    Ok(())
}

/// The midpoint of a segment is not projected to the midpoint of the images.
#[must_use]
pub fn central_projection_not_affine() -> Figure {
    Figure::new(
        "affine-central-projection-not-affine",
        "A central projection does not keep midpoints",
        "Rays lead from the centre O through the ends and the midpoint M of a segment AB to a horizontal line. \
         There the image of M, a large dot, is not the midpoint of the images of A and B, which is marked by a cross.",
    )
    .handle("A", [0.0, 1.0])
    .handle("B", [2.0, 2.0])
    .draw(|values, canvas| {
        let onto = Line::new([0.0, 1.0], 1.0)?;
        let projection = CentralProjection::new(Point::origin(), onto)?;
        let (a, b) = (values.point("A")?, values.point("B")?);
        let m = a.lerp(&b, 0.5);
        canvas.window([-0.5, -0.15], [2.5, 2.2]);
        canvas.line("image line", [0.0, 1.0], [1.0, 1.0], Style::Connector);
        canvas.segment("AB", a, b, Style::Curve);
        canvas.point("O", Place::origin(), PointStyle::Guide);
        canvas.points("ends", [a, b], PointStyle::Control);
        canvas.point("M", m, PointStyle::OnCurve);
        for (name, at) in [("A", a), ("B", b), ("M", m), ("O", Place::origin())] {
            canvas.label(name, at);
        }
        // Points level with the centre have no image.
        let images = [a, b, m].map(|point| projection.point(&point).ok());
        for (name, (point, image)) in std::iter::zip(["A'", "B'", "M'"], std::iter::zip([a, b, m], images)) {
            if let Some(image) = image {
                let far = if point[1].abs() > image[1] { point } else { image };
                canvas.segment(&format!("ray {name}"), Place::origin(), far, Style::Guide);
                canvas.label(name, image);
            }
        }
        if images.contains(&None) {
            canvas.remark("A point at the height of the centre has no image: its ray is parallel to the image line.");
        } else if a[1] == b[1] {
            canvas.remark("AB is parallel to the image line: only then the midpoint goes to the midpoint.");
        }
        if let [Some(a), Some(b), Some(m)] = images {
            canvas.points("images of the ends", [a, b], PointStyle::Level(1));
            canvas.point("image of M", m, PointStyle::Result);
            canvas.point("midpoint of the images", a.lerp(&b, 0.5), PointStyle::Cross);
        }
        Ok(())
    })
}

/// A triangle with a point, and their images under the map that the images of the corners determine.
#[must_use]
pub fn exercise_image_of_points() -> Figure {
    Figure::new(
        "affine-exercise-image-of-points",
        "Three images determine an affine map",
        "On the left a triangle ABC with a point M; the line from A through M meets the opposite side in D. \
         On the right the images of the corners, and the image of M: it divides the image of the segment AD in the same ratio \
         as M divides AD. A text gives the barycentric coordinates of M.",
    )
    .handle_in("triangle", "A", [0.4, 0.0])
    .handle_in("triangle", "B", [4.0, 0.6])
    .handle_in("triangle", "C", [1.0, 3.4])
    .handle_in("triangle", "M", [1.72, 1.54])
    .handle_in("image", "A'", [3.8, 0.2])
    .handle_in("image", "B'", [0.4, 1.0])
    .handle_in("image", "C'", [3.0, 3.2])
    .draw(|values, canvas| {
        let [a, b, c] = [values.point("A")?, values.point("B")?, values.point("C")?];
        let images = [values.point("A'")?, values.point("B'")?, values.point("C'")?];
        let m = values.point("M")?;
        canvas.panel("triangle");
        canvas.caption("$M$ in the triangle");
        canvas.polygon("ABC", [a, b, c], Style::Region);
        canvas.polygon("sides", [a, b, c], Style::Connector);
        for (name, at) in [("A", a), ("B", b), ("C", c), ("M", m)] {
            canvas.label(name, at);
        }
        let basis = AffineBasis::new([a, b, c]);
        let coordinates = basis.as_ref().map(|basis| basis.coordinates(&m)).ok();
        let text = match &coordinates {
            Some(weights) => {
                let weights: Vec<String> = weights.iter().map(|w| decimal(*w, 2)).collect();
                format!("M = {}A {}B {}C", weights[0], signed(&weights[1]), signed(&weights[2]))
            }
            None => "$A$, $B$, $C$ are collinear".into(),
        };
        canvas.text("coordinates", &text, [2.2, -0.7], Side::Centre);
        // The line AM is parallel to BC if the weight of A is 1.
        let on_side = coordinates
            .as_ref()
            .filter(|weights| weights[0] != 1.0)
            .map(|weights| weights[2] / (1.0 - weights[0]));
        if let Some(t) = on_side {
            canvas.segment("AD", a, b.lerp(&c, t), Style::Guide);
            canvas.point("D", b.lerp(&c, t), PointStyle::Guide);
            canvas.label("D", b.lerp(&c, t));
        }
        canvas.point("M", m, PointStyle::OnCurve);

        canvas.panel("image");
        canvas.caption("$T(M)$ among the images");
        canvas.polygon("image of ABC", images, Style::SecondRegion);
        canvas.polygon("image of the sides", images, Style::Connector);
        for (name, at) in std::iter::zip(["A'", "B'", "C'"], images) {
            canvas.label(name, at);
        }
        if let (Ok(basis), Some(t)) = (&basis, on_side) {
            let map = AffineMap::from_images(basis, &images)?;
            let d = images[1].lerp(&images[2], t);
            canvas.segment("image of AD", images[0], d, Style::Guide);
            canvas.point("D'", d, PointStyle::Guide);
            canvas.label("D'", d);
            canvas.point("T(M)", map.point(&m), PointStyle::Result);
            canvas.label("T(M)", map.point(&m));
        }
        match (&basis, &coordinates) {
            (Ok(basis), Some(weights)) => {
                let map = AffineMap::from_images(basis, &images)?;
                let law = laws::map_determined_by_basis(|_, _| map.clone(), basis, &images, &weights[1..]);
                canvas.law("affine-map-determined-by-basis", &law);
            }
            _ => canvas.remark(
                "A, B and C are on a line: points beside it are no combinations of them, \
                 and their images are not determined.",
            ),
        }
        Ok(())
    })
}

/// A decimal number with its sign in front, as a term of a sum.
fn signed(number: &str) -> String {
    match number.strip_prefix('-') {
        Some(number) => format!("- {number}"),
        None => format!("+ {number}"),
    }
}

/// A grid and its image under an affine map given by the images of the origin and the unit points.
#[must_use]
pub fn map_properties() -> Figure {
    Figure::new(
        "affine-map-properties",
        "What an affine map keeps of a grid",
        "On the left a square grid with a shaded unit cell, a circle and a segment PQ that is divided at R. \
         On the right their image: two families of parallel lines at equal distances, the cell a parallelogram, the circle an ellipse, \
         and the image of R divides the image of PQ in the same ratio. Lengths and angles have changed.",
    )
    .handle_in("grid", "P", [0.5, 3.5])
    .handle_in("grid", "Q", [3.5, 0.5])
    .slider("\\lambda", 0.0..=1.0, 0.3)
    .handle_in("image", "O'", [0.8, 0.0])
    .handle_in("image", "E_1'", [1.7, 0.35])
    .handle_in("image", "E_2'", [0.45, 0.75])
    .draw(|values, canvas| {
        let images = [values.point("O'")?, values.point("E_1'")?, values.point("E_2'")?];
        let map = AffineMap::from_images(&AffineBasis::standard(), &images)?;
        let (p, q) = (values.point("P")?, values.point("Q")?);
        let lambda = values.number("\\lambda")?;
        canvas.panel("grid");
        canvas.caption("grid");
        grid(canvas, &Map::identity(), [p, q], lambda);
        for (name, at) in [("P", p), ("Q", q), ("R", p.lerp(&q, lambda))] {
            canvas.label(name, at);
        }
        canvas.panel("image");
        canvas.caption("affine image");
        grid(canvas, &map, [p, q], lambda);
        for (name, at) in [("P'", p), ("Q'", q), ("R'", p.lerp(&q, lambda))] {
            canvas.label(name, map.point(&at));
        }
        for (name, at) in std::iter::zip(["O'", "E_1'", "E_2'"], images) {
            canvas.point(name, at, PointStyle::Control);
        }
        let corner = Point::new([1.0, 0.0]);
        let law = laws::map_properties(AffineMap::point, &map, [&p, &q, &corner], lambda);
        canvas.law("affine-map-properties", &law);
        if map.determinant() == 0.0 {
            canvas.remark(
                "The three images are on a line: the map flattens the plane onto it. \
                 Ratios and parallels are kept all the same; areas become 0.",
            );
        }
        if p == q {
            canvas.remark("P and Q are in one place: no ratio is defined by a segment of length 0.");
        }
        Ok(())
    })
}

/// The image of a grid of four cells in each direction, with a cell, a circle and a divided segment.
fn grid(canvas: &mut Canvas, map: &Map, [p, q]: [Place; 2], lambda: f64) {
    let at = |x: f64, y: f64| map.point(&Point::new([x, y]));
    let corners = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
    canvas.polygon("cell", corners, Style::Region);
    for k in 0..=4 {
        let c = f64::from(k);
        canvas.segment(
            &format!("row {k}"),
            at(0.0, c),
            at(4.0, c),
            Style::Connector,
        );
        canvas.segment(
            &format!("column {k}"),
            at(c, 0.0),
            at(c, 4.0),
            Style::Connector,
        );
    }
    let circle = |angle: f64| at(3.0 + libm::cos(angle), 3.0 + libm::sin(angle));
    canvas.curve("circle", 0.0..=std::f64::consts::TAU, circle, Style::Curve);
    canvas.segment("PQ", map.point(&p), map.point(&q), Style::Tangent);
    canvas.points("ends", [map.point(&p), map.point(&q)], PointStyle::OnCurve);
    canvas.point("R", map.point(&p.lerp(&q, lambda)), PointStyle::Result);
}

/// The unit square and its image under a shear, between two parallels.
#[must_use]
pub fn figure_shear() -> Figure {
    Figure::new(
        "affine-figure-shear",
        "A shear keeps areas",
        "The unit square, dotted, and its image under the shear (x, y) to (x + ay, y): a parallelogram over the same base, \
         between the same two horizontal lines. A text says that both have the area 1.",
    )
    .slider("a", -1.5..=1.5, 0.75)
    .draw(|values, canvas| {
        let a = values.number("a")?;
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::new);
        let image = SimplePolygon::new(square)?.mapped(&Map::shear(a))?;
        canvas.window([-1.7, -0.35], [2.7, 1.5]);
        canvas.line("base line", [0.0, 0.0], [1.0, 0.0], Style::Guide);
        canvas.line("top line", [0.0, 1.0], [1.0, 1.0], Style::Guide);
        canvas.polygon("image", image.vertices().iter().copied(), Style::Disc);
        canvas.polygon("square", square, Style::Bound);
        let tip = Point::new([a, 1.0]);
        canvas.arrow("shift", [0.0, 1.0], tip, Style::Tangent);
        canvas.label_on(Side::Above, "a", Point::new([0.0, 1.0]).lerp(&tip, 0.5));
        let vectors = [Vector::from([1.0, 0.0]), Vector::from([a, 1.0])];
        canvas.label_on(Side::Below, "1", [0.5, 0.0]);
        let area = crate::affine::plane_determinant(&vectors[0], &vectors[1]);
        let text = format!("\\text{{area}} = {}", decimal(area, 3));
        canvas.text("area", &text, [-1.0, 0.5], Side::Centre);
        let corners = [square[0], square[1], square[2]];
        canvas.law("affine-shear", &laws::shear(Map::shear, a, &corners));
        if a == 0.0 {
            canvas.remark("For a = 0 the shear is the identity.");
        }
        Ok(())
    })
}
