//! Wrong corner cutting.

use cagd::affine::Affine;
use cagd::scalar::Scalar;
use cagd::subdivision::ControlPolygon;

fn polygon<P: Affine>(like: &ControlPolygon<P>, vertices: Vec<P>) -> ControlPolygon<P> {
    ControlPolygon::new(vertices, like.closing()).expect("finite vertices")
}

/// The vertices after one step of Lane and Riesenfeld; those of the polygon itself where it is too short.
fn averaged<P: Affine>(given: &ControlPolygon<P>, degree: usize) -> Vec<P> {
    let refined = given
        .lane_riesenfeld(degree)
        .unwrap_or_else(|_| given.clone());
    refined.vertices().to_vec()
}

/// Every leg cut at these two places.
fn cut_at<P: Affine>(given: &ControlPolygon<P>, places: [(i64, i64); 2]) -> ControlPolygon<P> {
    let cuts = given
        .legs()
        .flat_map(|(start, end)| places.map(|(p, q)| start.lerp(end, P::Scalar::from_ratio(p, q))));
    polygon(given, cuts.collect())
}

/// Cuts every leg into thirds.
pub fn cut_at_thirds<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    cut_at(given, [(1, 3), (2, 3)])
}

/// Takes the two cuts of a leg in the wrong order.
pub fn cuts_swapped<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    cut_at(given, [(3, 4), (1, 4)])
}

/// Cuts only the start of each leg, so that it is not symmetric.
pub fn cut_at_one_end<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    cut_at(given, [(0, 1), (1, 2)])
}

/// Keeps the first and the last vertex, as if the ends had to stay.
pub fn ends_kept<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    let mut cuts = given.chaikin().expect("a leg").vertices().to_vec();
    if let [first, .., last] = cuts.as_mut_slice() {
        *first = given.vertices()[0].clone();
        *last = given.vertices()[given.vertices().len() - 1].clone();
    }
    polygon(given, cuts)
}

/// Forgets the leg from the last vertex back to the first; an open polygon loses its last leg.
pub fn last_leg_forgotten<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    let cut = given.chaikin().expect("a leg");
    let mut cuts = cut.vertices().to_vec();
    cuts.truncate((cuts.len() - 2).max(1));
    polygon(given, cuts)
}

/// Does nothing.
pub fn nothing_cut<P: Affine>(given: &ControlPolygon<P>) -> ControlPolygon<P> {
    given.clone()
}

/// Takes the weights 3/4 and 1/2, which do not sum to 1.
pub fn weights_do_not_sum_to_one<T: Scalar>(given: &ControlPolygon<T>) -> ControlPolygon<T> {
    let [quarters, half] = [T::from_ratio(3, 4), T::from_ratio(1, 2)];
    let cuts = given.legs().flat_map(|(start, end)| {
        let mean = |near: &T, far: &T| quarters.clone() * near.clone() + half.clone() * far.clone();
        [mean(start, end), mean(end, start)]
    });
    polygon(given, cuts.collect())
}

/// Keeps the old vertices, but moves the first.
pub fn one_vertex_moved<T: Scalar>(given: &ControlPolygon<T>) -> ControlPolygon<T> {
    let mut vertices = averaged(given, 1);
    if let [first, second, ..] = vertices.as_mut_slice() {
        *first = second.clone();
    }
    polygon(given, vertices)
}

/// Begins with linear subdivision and averages n times: one averaging too many.
pub fn averaged_once_more<P: Affine>(
    given: &ControlPolygon<P>,
    degree: usize,
) -> ControlPolygon<P> {
    polygon(given, averaged(given, degree + 1))
}

/// Averages n − 1 times.
pub fn averaged_once_less<P: Affine>(
    given: &ControlPolygon<P>,
    degree: usize,
) -> ControlPolygon<P> {
    polygon(given, averaged(given, degree.saturating_sub(1)))
}

/// Doubles in every round, not only once; takes the first vertices of what that gives.
pub fn doubled_every_round<P: Affine>(
    given: &ControlPolygon<P>,
    degree: usize,
) -> ControlPolygon<P> {
    let count = averaged(given, degree).len();
    let mut rounds = given.doubled();
    for _ in 0..degree {
        rounds = rounds.averaged().unwrap_or(rounds).doubled();
    }
    let vertices = rounds.vertices().iter().cycle().take(count).cloned();
    polygon(given, vertices.collect())
}

/// Does not double at all.
pub fn not_doubled<P: Affine>(given: &ControlPolygon<P>, degree: usize) -> ControlPolygon<P> {
    (0..degree).fold(given.clone(), |rounds, _| {
        rounds.averaged().unwrap_or(rounds)
    })
}
