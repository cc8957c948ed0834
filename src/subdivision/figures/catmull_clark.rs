//! Figures of Catmull–Clark subdivision, its limits and creases.

use crate::affine::Point;
use crate::figure::{BoxError, Canvas, Figure, Place, PointStyle, Style, Surface, View};
use crate::subdivision::{
    CatmullClark, Creases, EdgeId, HalfEdgeMesh, Mesh, SurfaceScheme, VertexId, laws, solids,
};

/// The radius of the ball on which the handle of the view lies.
const KNOB: f64 = 1.3;

type Solid = Mesh<Point<f64, 3>>;

pub(super) fn all() -> Vec<Figure> {
    vec![figure_catmull_clark(), catmull_clark_limit(), creases()]
}

/// The mesh as a closed surface.
pub(super) fn closed_surface(mesh: &Solid, steps: usize) -> Surface {
    let faces = mesh.connectivity().face_lists();
    let surface = Surface::new(mesh.points().iter().copied(), faces).closed();
    // Beyond three steps the lines would cover what they outline.
    if steps > 3 {
        surface.without_edges()
    } else {
        surface
    }
}

/// A weight as a fraction, with this number in the denominator before it is reduced.
pub(super) fn fraction(weight: f64, whole: i64) -> String {
    let numerator = libm::round(weight * whole as f64) as i64;
    let common = greatest_common_divisor(numerator.abs(), whole);
    match (numerator / common, whole / common) {
        (n, 1) => n.to_string(),
        (n, d) => format!("{n}/{d}"),
    }
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 {
        a.max(1)
    } else {
        greatest_common_divisor(b, a % b)
    }
}

/// The edges of a plane mesh, one segment each.
pub(super) fn edges(canvas: &mut Canvas, name: &str, mesh: &HalfEdgeMesh, places: &[Place]) {
    for e in mesh.edges() {
        let [a, b] = mesh.edge_vertices(e).map(|v| places[v.index()]);
        canvas.segment(&format!("{name} {}", e.0), a, b, Style::Connector);
    }
}

/// The weights of a new point of Catmull–Clark subdivision on a grid of 2 × 2 quadrilaterals: those that are not 0.
fn weights(new: usize) -> Result<Vec<(usize, f64)>, BoxError> {
    let grid = solids::grid::<f64>(2, 2);
    let units =
        (0..9).map(|one| Point::new(std::array::from_fn(|i| f64::from(u8::from(i == one)))));
    let units: Mesh<Point<f64, 9>> = Mesh::new(grid.connectivity().clone(), units.collect())?;
    let refined = CatmullClark.refine(&units)?;
    let weights = refined.points()[new]
        .coordinates()
        .iter()
        .copied()
        .enumerate();
    Ok(weights.filter(|(_, weight)| *weight != 0.0).collect())
}

/// The three stencils, and the cube after some steps.
#[must_use]
pub fn figure_catmull_clark() -> Figure {
    const PANELS: [&str; 3] = ["face point", "edge point", "vertex point"];
    Figure::new(
        "subdivision-figure-catmull-clark",
        "The three stencils of a regular mesh, and a cube that becomes round",
        "Three stencils on a regular grid of quadrilaterals, with their weights. \
         The face point has the weight 1/4 at the four vertices of its face. \
         The edge point has 3/8 at the two ends of the edge and 1/16 at the other four vertices of the faces beside it. \
         The vertex point has 9/16 at the old vertex, 3/32 at its four neighbours and 1/64 at the four opposite vertices. \
         Beside it a cube after a number of steps, which looks more and more like a ball.",
    )
    .rows(&[&PANELS[..2], &[PANELS[2], "cube"]])
    .stepper("steps", 0..=4, 2)
    .handle_in("cube", "view", View::degrees(32.0, 24.0).knob(KNOB))
    .draw(|values, canvas| {
        let grid = solids::grid::<f64>(2, 2);
        let mesh = grid.connectivity();
        let places: Vec<Place> = grid.points().iter().map(|p| Point::new([p[0], p[1]])).collect();
        let refined = CatmullClark.refine(&grid)?;
        let middle = mesh
            .edges()
            .find(|&e| !mesh.is_boundary_edge(e))
            .map_or(0, EdgeId::index);
        let [v, e] = [mesh.vertex_count(), mesh.edge_count()];
        for (panel, new) in PANELS.into_iter().zip([v + e, v + middle, 4]) {
            canvas.panel(panel);
            canvas.caption(panel);
            edges(canvas, "edge", mesh, &places);
            let at = refined.points()[new];
            let stencil = weights(new)?;
            let stencil = stencil
                .into_iter()
                .map(|(i, weight)| (places[i], fraction(weight, 64)));
            canvas.stencil("stencil", stencil, Point::new([at[0], at[1]]));
        }
        let steps = values.count("steps")?;
        let cube = CatmullClark.refine_times(&solids::cube(), steps)?;
        let view = View::of_knob(values.point("view")?, KNOB);
        canvas.panel("cube");
        canvas.caption(&match steps {
            1 => "the cube after 1 step".to_owned(),
            steps => format!("the cube after {steps} steps"),
        });
        canvas.surface("surface", &view, &closed_surface(&cube, steps));
        canvas.law(
            "subdivision-catmull-clark",
            &laws::catmull_clark(|mesh| CatmullClark.refine(mesh), &solids::cube::<f64>()),
        );
        Ok(())
    })
}

/// The vertices of the cube, their limits and normals, and the surface after four steps.
#[must_use]
pub fn catmull_clark_limit() -> Figure {
    Figure::new(
        "subdivision-catmull-clark-limit",
        "Limit positions and normals of the vertices of a cube",
        "A cube, drawn by its edges, and the smooth body that Catmull–Clark subdivision makes of it, drawn after four steps. \
         From the vertices of the cube that are in front a line leads half of the way to the centre, \
         where a point marks the limit of the vertex on the body; an arrow there shows the normal.",
    )
    .handle("view", View::degrees(32.0, 24.0).knob(KNOB))
    .draw(|values, canvas| {
        let view = View::of_knob(values.point("view")?, KNOB);
        let cube = solids::cube::<f64>();
        let body = CatmullClark.refine_times(&cube, 4)?;
        canvas.surface("body", &view, &closed_surface(&body, 4));
        let mesh = cube.connectivity();
        let places: Vec<Place> = cube.points().iter().map(|p| view.place(p)).collect();
        // The edges at the farthest vertex are behind the body.
        let depth = |v: VertexId| view.seen(cube.point(v))[2];
        let farthest = mesh.vertices().min_by(|&a, &b| depth(a).total_cmp(&depth(b)));
        for e in mesh.edges() {
            let ends = mesh.edge_vertices(e);
            if !ends.iter().any(|&v| Some(v) == farthest) {
                let [a, b] = ends.map(|v| places[v.index()]);
                canvas.segment(&format!("edge {}", e.0), a, b, Style::Connector);
            }
        }
        for v in mesh.vertices() {
            let limit = CatmullClark.limit_position(&cube, v)?;
            let [first, second] = CatmullClark.limit_tangents(&cube, v)?;
            let normal = first.cross(&second).normalize();
            // What is behind the body is not seen.
            if view.seen(&Point::from(<[f64; 3]>::from(normal)))[2] <= 0.0 {
                continue;
            }
            let at = view.place(&limit);
            canvas.segment(&format!("way {}", v.0), places[v.index()], at, Style::Guide);
            canvas.arrow(&format!("normal {}", v.0), at, view.place(&(limit + normal * 0.6)), Style::Tangent);
            canvas.point(&format!("limit {}", v.0), at, PointStyle::Result);
            canvas.label(&format!("v_{}", v.0), places[v.index()]);
            canvas.law("subdivision-catmull-clark-limit", &laws::catmull_clark_limit(
                |mesh, v| CatmullClark.limit_position(mesh, v),
                &cube,
                v,
            ));
        }
        Ok(())
    })
}

/// A cube whose edges are sharp or not, after three steps.
#[must_use]
pub fn creases() -> Figure {
    Figure::new(
        "subdivision-creases",
        "Sharp edges stay sharp, the rest becomes round",
        "A cube after three steps of Catmull–Clark subdivision. \
         The four edges around its top are sharp, the others are not: \
         the top is bounded by a sharp rim, a closed smooth curve, and the rest is round. \
         With other edges made sharp the body becomes a drum, a pillow with four ridges, or the cube itself.",
    )
    .choice("top", &["smooth", "sharp"], 1)
    .choice("bottom", &["smooth", "sharp"], 0)
    .choice("sides", &["smooth", "sharp"], 0)
    .stepper("steps", 0..=4, 3)
    .handle("view", View::degrees(32.0, 24.0).knob(KNOB))
    .draw(|values, canvas| {
        let view = View::of_knob(values.point("view")?, KNOB);
        let mut body = solids::cube::<f64>();
        let chosen = [values.count("bottom")?, values.count("sides")?, values.count("top")?];
        // The height of an edge's middle says which kind it is.
        let kind = |mesh: &Solid, e: EdgeId| {
            let [a, b] = mesh.connectivity().edge_vertices(e).map(|v| mesh.point(v)[2]);
            match a + b {
                z if z < 0.0 => 0,
                z if z > 0.0 => 2,
                _ => 1,
            }
        };
        let mesh = body.connectivity();
        let sharp: Vec<EdgeId> = mesh
            .edges()
            .filter(|&e| chosen[kind(&body, e)] == 1)
            .collect();
        let mut creases = Creases::new(mesh, sharp, [])?;
        canvas.law(
            "subdivision-creases",
            &laws::creases(
                |mesh, creases| CatmullClark.refine_creased(mesh, creases),
                &body,
                &creases,
            ),
        );
        match chosen {
            [0, 0, 0] => canvas.remark("No edge is sharp: the rules are those of Catmull and Clark."),
            [1, 1, 1] => canvas.remark(
                "All edges are sharp: three of them meet in each vertex, so all vertices are corners, which stay; the cube remains.",
            ),
            _ => {}
        }
        let steps = values.count("steps")?;
        for _ in 0..steps {
            (body, creases) = CatmullClark.refine_creased(&body, &creases)?;
        }
        canvas.surface("body", &view, &closed_surface(&body, steps));
        let mesh = body.connectivity();
        let place = |v: VertexId| view.place(body.point(v));
        // A face that is seen has its corners counterclockwise in the picture.
        let seen = |h| {
            let corners: Vec<Place> = mesh.face(h).map_or_else(Vec::new, |f| {
                mesh.face_vertices(f).map(place).collect()
            });
            match corners[..] {
                [a, b, c, d] => (c - a).perp(&(d - b)) > 0.0,
                _ => false,
            }
        };
        for e in creases.sharp_edges() {
            let h = mesh.edge_half_edge(e);
            if seen(h) || seen(mesh.flip(h)) {
                let [a, b] = mesh.edge_vertices(e).map(place);
                canvas.segment(&format!("crease {}", e.0), a, b, Style::Tangent);
            }
        }
        Ok(())
    })
}
