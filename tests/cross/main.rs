//! The same results as code that nobody here wrote: kurbo and lyon_geom, for degrees up to 3.

mod bezier;
