use cagd::affine::{LatticePolygon, Location, Point};
use cagd::check::{Picture, claim};

fn probes() -> Vec<String> {
    let region = answer::region();
    let numbers = (region.interior, region.boundary, region.twice_area);
    cagd::probes![
        format!("{:?}", region.outer),
        format!("{:?}", region.hole),
        format!("{numbers:?}"),
    ]
}

fn picture(region: &answer::Region) -> Picture {
    let outline = |vertices: &[[i64; 2]]| {
        let corners: Vec<_> = vertices.iter().chain(vertices.first()).collect();
        corners
            .into_iter()
            .map(|xy| Point::new(xy.map(|n| n as f64)))
            .collect::<Vec<_>>()
    };
    Picture::new()
        .given(outline(&region.outer))
        .found(outline(&region.hole))
}

/// One of the two polygons; a failed claim if the vertices are none.
fn polygon(region: &answer::Region, name: &str, vertices: &[[i64; 2]]) -> LatticePolygon {
    let is_near = vertices.iter().flatten().all(|x| (-100..=100).contains(x));
    claim(format!("the vertices of the {name}"))
        .input(format!("{vertices:?}"))
        .holds(is_near, "coordinates from −100 to 100", "a larger one");
    match LatticePolygon::new(vertices.to_vec()) {
        Ok(polygon) => polygon,
        Err(error) => {
            claim(format!("the vertices of the {name}"))
                .input(format!("{vertices:?}"))
                .picture(|| picture(region))
                .holds(false, "a simple polygon", error);
            unreachable!("the claim has failed")
        }
    }
}

fn place([x, y]: [i64; 2]) -> Point<f64, 2> {
    Point::new([x as f64, y as f64])
}

/// Whether the edges from p to q and from r to s have a point in common.
fn meet([p, q]: [[i64; 2]; 2], [r, s]: [[i64; 2]; 2]) -> bool {
    let side = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
    };
    // On one line the boxes decide; otherwise they overlap too if the edges meet.
    let overlap = |k: usize| p[k].min(q[k]) <= r[k].max(s[k]) && r[k].min(s[k]) <= p[k].max(q[k]);
    side(p, q, r) * side(p, q, s) <= 0
        && side(r, s, p) * side(r, s, q) <= 0
        && overlap(0)
        && overlap(1)
}

fn edges(vertices: &[[i64; 2]]) -> Vec<[[i64; 2]; 2]> {
    (0..vertices.len())
        .map(|i| [vertices[i], vertices[(i + 1) % vertices.len()]])
        .collect()
}

/// Both polygons, once it is clear that the hole is one.
fn checked(region: &answer::Region) -> [LatticePolygon; 2] {
    let outer = polygon(region, "outer polygon", &region.outer);
    let hole = polygon(region, "hole", &region.hole);
    let is_inside = outer.polygon().locate(&place(region.hole[0])) == Location::Inside;
    let touching = edges(&region.outer).into_iter().any(|outer| {
        edges(&region.hole)
            .into_iter()
            .any(|inner| meet(outer, inner))
    });
    claim("where the hole lies")
        .input(format!("outer {:?}, hole {:?}", region.outer, region.hole))
        .picture(|| picture(region))
        .holds(
            is_inside && !touching,
            "inside of the outer polygon, without touching its boundary",
            if touching {
                "the boundaries touch"
            } else {
                "it is not inside"
            },
        );
    [outer, hole]
}

/// Why: before anything is counted there must be a hole: two simple polygons, one inside of the other.
#[test]
fn the_region_has_a_hole() {
    checked(&answer::region());
}

/// The numbers are right: every lattice point around is tried.
#[test]
fn the_numbers_are_right() {
    let region = answer::region();
    let polygons = checked(&region);
    let (mut interior, mut boundary) = (0, 0);
    for x in -100..=100 {
        for y in -100..=100 {
            match polygons
                .each_ref()
                .map(|polygon| polygon.polygon().locate(&place([x, y])))
            {
                [Location::Boundary, _] | [_, Location::Boundary] => boundary += 1,
                [Location::Inside, Location::Outside] => interior += 1,
                _ => {}
            }
        }
    }
    let doubled = |vertices: &[[i64; 2]]| {
        let determinants = edges(vertices)
            .into_iter()
            .map(|[p, q]| p[0] * q[1] - p[1] * q[0]);
        determinants.sum::<i64>().abs()
    };
    let twice_area = doubled(&region.outer) - doubled(&region.hole);
    claim("I, R and 2A of the region")
        .input(format!("outer {:?}, hole {:?}", region.outer, region.hole))
        .picture(|| picture(&region))
        .equal(
            (region.interior, region.boundary, region.twice_area),
            (interior, boundary, twice_area),
        );
}

/// Why: this is what the exercise asks for; with the right numbers of a region with a hole it is so.
#[test]
fn the_formula_fails() {
    let answer::Region {
        interior,
        boundary,
        twice_area,
        ..
    } = answer::region();
    claim("Pick's formula for the region")
        .input(format!("I = {interior}, R = {boundary}, 2A = {twice_area}"))
        .holds(
            i128::from(twice_area) != 2 * i128::from(interior) + i128::from(boundary) - 2,
            "2A ≠ 2I + R − 2",
            "2A = 2I + R − 2",
        );
}
