//! The numbers of vertices, half-edges, edges and faces, each a type of its own.

use std::fmt;

macro_rules! id {
    ($name:ident, $word:literal, $documentation:literal) => {
        #[doc = $documentation]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub u32);

        impl $name {
            /// The number as an index of a list.
            #[must_use]
            #[inline]
            pub fn index(self) -> usize {
                self.0 as usize
            }

            /// The element with this number; meshes have fewer than 2³² elements of a kind.
            #[inline]
            pub(in crate::subdivision) fn at(index: usize) -> Self {
                Self(index as u32)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($word, " {}"), self.0)
            }
        }
    };
}

id!(VertexId, "vertex", "The number of a vertex, from 0 on.");
id!(
    HalfEdgeId,
    "half-edge",
    "The number of a half-edge, from 0 on: first those with a face, then those along the boundary."
);
id!(EdgeId, "edge", "The number of an edge, from 0 on.");
id!(FaceId, "face", "The number of a face, from 0 on.");
