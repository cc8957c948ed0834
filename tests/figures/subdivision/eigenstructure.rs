//! Figures of the section on eigenvalues and characteristic maps.

use cagd::subdivision::figures;

use crate::support::{ensure, figure_test};

/// The lines have the known eigenvalues.
#[test]
fn matrix() {
    figure_test(figures::matrix(), |plot| {
        let tau = std::f64::consts::TAU;
        let line = |name: &str| plot.polyline(&format!("lambda/{name}"));
        for (i, k) in (3..=12).enumerate() {
            let k = f64::from(k);
            let (c, half) = ((tau / k).cos(), (tau / (2.0 * k)).cos());
            let catmull_clark = (5.0 + c + half * (18.0 + 2.0 * c).sqrt()) / 16.0;
            let known = [
                ("Loop", 0.375 + c / 4.0),
                ("modified Butterfly", 0.5),
                ("Catmull–Clark", catmull_clark),
                ("Doo–Sabin", 0.5),
            ];
            for (name, value) in known {
                let found = line(name)?[i][1];
                // Eigenvalues of blocks of at most six rows are right to many more digits.
                ensure((found - value).abs() < 1e-9, || {
                    format!("{name}, valence {k}: {found}, expected {value}")
                })?;
            }
            for name in [
                "Loop",
                "modified Butterfly",
                "Catmull–Clark",
                "Doo–Sabin",
                "Kobbelt",
            ] {
                let (first, third) = (
                    line(name)?[i][1],
                    plot.polyline(&format!("third/{name}"))?[i][1],
                );
                ensure(third < first - 1e-3, || {
                    format!("{name}, valence {k}: {third} is not below {first}")
                })?;
            }
        }
        Ok(())
    })
    .rejects("a lower eigenvalue", |plot| {
        plot.shifted("lambda/Loop", [0.0, -0.01])
    })
    .rejects("a third eigenvalue as large", |plot| {
        plot.shifted("third/Kobbelt", [0.0, 0.2])
    })
    .snapshot();
}

/// All faces are seen from their front, and the border runs around the centre once.
#[test]
fn characteristic_map() {
    figure_test(figures::characteristic_map(), |plot| {
        let ring = plot.surface("ring")?;
        // Twelve triangles a sector in one old ring after a step: 5 · (4² − 2²).
        ensure(ring.faces.len() == 60, || {
            format!("{} faces", ring.faces.len())
        })?;
        for face in ring.faces {
            let [a, b, c] = [0, 1, 2].map(|i: usize| ring.places[face.corners[i] as usize]);
            let area = cagd::affine::signed_area(&a, &b, &c);
            ensure(area > 0.0, || {
                format!("face {} is turned over", face.number)
            })?;
        }
        let border = plot.polyline("inner border")?;
        let angles = border.windows(2).map(|pair| {
            let [p, q] = [pair[0], pair[1]];
            (p[0] * q[1] - p[1] * q[0]).atan2(p[0] * q[0] + p[1] * q[1])
        });
        let turns = angles.sum::<f64>() / std::f64::consts::TAU;
        ensure((turns - 1.0).abs() < 1e-9, || format!("{turns} turns"))
    })
    .rejects("a border that does not surround the centre", |plot| {
        plot.shifted("inner border", [5.0, 0.0])
    })
    .snapshot();
}
