//! Whether a curve scheme keeps the vertices that it is given.

use super::polygon::ControlPolygon;
use crate::scalar::Scalar;

/// The two kinds of subdivision schemes.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::SchemeKind;
///
/// assert_eq!(SchemeKind::of::<f64>(|polygon| polygon.chaikin()).unwrap(), SchemeKind::Approximating);
/// // With one averaging, midpoints are inserted between the vertices.
/// let inserting = SchemeKind::of::<f64>(|polygon| polygon.lane_riesenfeld(1));
/// assert_eq!(inserting.unwrap(), SchemeKind::Interpolating { first: 0 });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SchemeKind {
    /// Old vertices are not kept; the limit need not pass through them.
    Approximating,
    /// Every second new vertex is an old one, so the limit passes through all of them.
    Interpolating {
        /// Where the old vertex 0 stands in the refined closed polygon.
        first: usize,
    },
}

/// How many vertices the polygon has on which a rule is tried out.
///
/// The weights of a rule that reaches over more than so many vertices would overlap.
const PROBE: usize = 16;

impl SchemeKind {
    /// The kind of the scheme that refines by these rules.
    ///
    /// The rules must be linear and the same everywhere, and double the number of vertices of a closed polygon.
    /// Then the scheme is known from what it makes of one vertex 1 among zeros.
    /// It must reach over at most 16 vertices.
    ///
    /// # Errors
    ///
    /// That of the scheme.
    pub fn of<T: Scalar>(
        refine: impl Fn(&ControlPolygon<T>) -> Result<ControlPolygon<T>, super::ControlPolygonError>,
    ) -> Result<Self, super::ControlPolygonError> {
        let impulse = (0..PROBE as i64).map(|i| T::from_integer(i64::from(i == 0)));
        let refined = refine(&ControlPolygon::closed(impulse)?)?;
        let response = refined.vertices();
        // Every second value from `first` on must be the impulse again.
        let keeps = |first: usize| {
            response[first].is_one()
                && (1..PROBE).all(|i| response[(first + 2 * i) % response.len()].is_zero())
        };
        Ok(match (0..response.len()).find(|&first| keeps(first)) {
            Some(first) => Self::Interpolating { first },
            None => Self::Approximating,
        })
    }
}
