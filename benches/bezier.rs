//! Bézier curves beside kurbo and lyon_geom, in one run.
//!
//! What was measured, and how to read it, is in `README.md` beside this file.

use std::hint::black_box;

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use kurbo::ParamCurve;

/// Parameters in a batch: the points fit into the first-level cache with room to spare.
const BATCH: usize = 1024;

const CUBIC: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 4.5], [8.5, 6.5], [11.0, 2.0]];

fn parameters() -> Vec<f64> {
    (0..BATCH).map(|k| k as f64 / (BATCH - 1) as f64).collect()
}

fn cubic_batch(c: &mut Criterion) {
    let mut group = c.benchmark_group("cubic, 1024 points of the plane");
    group.throughput(Throughput::Elements(BATCH as u64));
    let t = parameters();

    let curve = BezierCurve::new(CUBIC.map(Point::new)).expect("finite control points");
    let mut points = vec![Point::origin(); BATCH];
    group.bench_function("cagd, interleaved points", |b| {
        b.iter(|| {
            let curve = black_box(&curve);
            curve
                .evaluate_into(black_box(&t), &mut points)
                .expect("equal lengths");
            black_box(&mut points);
        });
    });

    let (mut x, mut y) = (vec![0.0; BATCH], vec![0.0; BATCH]);
    group.bench_function("cagd, split arrays", |b| {
        b.iter(|| {
            let curve = black_box(&curve);
            curve
                .evaluate_split_into(black_box(&t), [&mut x, &mut y])
                .expect("equal lengths");
            black_box((&mut x, &mut y));
        });
    });

    let [p0, p1, p2, p3] = CUBIC.map(|[x, y]| kurbo::Point::new(x, y));
    let cubic = kurbo::CubicBez::new(p0, p1, p2, p3);
    let mut points = vec![kurbo::Point::ZERO; BATCH];
    group.bench_function("kurbo, eval in a loop", |b| {
        b.iter(|| {
            let cubic = black_box(cubic);
            for (point, &t) in points.iter_mut().zip(black_box(&t)) {
                *point = cubic.eval(t);
            }
            black_box(&mut points);
        });
    });

    let [p0, p1, p2, p3] = CUBIC.map(|[x, y]| lyon_geom::point(x, y));
    let cubic = lyon_geom::CubicBezierSegment {
        from: p0,
        ctrl1: p1,
        ctrl2: p2,
        to: p3,
    };
    let mut points = vec![lyon_geom::point(0.0, 0.0); BATCH];
    group.bench_function("lyon_geom, sample in a loop", |b| {
        b.iter(|| {
            let cubic = black_box(cubic);
            for (point, &t) in points.iter_mut().zip(black_box(&t)) {
                *point = cubic.sample(t);
            }
            black_box(&mut points);
        });
    });
    group.finish();
}

fn high_degree(c: &mut Criterion) {
    let mut group = c.benchmark_group("degree 10, 1024 points of the plane");
    group.throughput(Throughput::Elements(BATCH as u64));
    let t = parameters();
    let control_points = (0..=10).map(|i: i32| Point::new([f64::from(i), f64::from((i * i) % 7)]));
    let curve = BezierCurve::new(control_points).expect("finite control points");
    let mut points = vec![Point::origin(); BATCH];
    group.bench_function("cagd, interleaved points", |b| {
        b.iter(|| {
            let curve = black_box(&curve);
            curve
                .evaluate_into(black_box(&t), &mut points)
                .expect("equal lengths");
            black_box(&mut points);
        });
    });
    group.bench_function("cagd, de Casteljau one by one", |b| {
        b.iter(|| {
            let curve = black_box(&curve);
            for (point, &t) in points.iter_mut().zip(black_box(&t)) {
                *point = curve.at(t);
            }
            black_box(&mut points);
        });
    });
    group.finish();
}

/// A hundred cubics with control points spread over a box of size 1000.
fn cubics() -> Vec<[[f64; 2]; 4]> {
    // Multiples of irrational numbers modulo 1 are spread evenly (Weyl); no random numbers needed.
    let spread = |k: usize, irrational: f64| 1000.0 * (k as f64 * irrational).fract();
    let point = |k: usize| {
        [
            spread(k, 0.618_033_988_749_894_9),
            spread(k, 0.414_213_562_373_095_1),
        ]
    };
    (0..100)
        .map(|k| [0, 1, 2, 3].map(|i| point(4 * k + i + 1)))
        .collect()
}

/// The tolerance of flattening: a tenth of a unit in the box of size 1000.
const TOLERANCE: f64 = 0.1;

fn flattening(c: &mut Criterion) {
    let mut group = c.benchmark_group("flattening 100 cubics in a box of 1000 to 0.1");
    let curves: Vec<_> = cubics()
        .into_iter()
        .map(|points| BezierCurve::new(points.map(Point::new)).expect("finite control points"))
        .collect();
    group.bench_function("cagd, few chords", |b| {
        b.iter(|| {
            let polylines = black_box(&curves)
                .iter()
                .map(|curve| curve.flattened(TOLERANCE));
            polylines
                .map(|polyline| polyline.expect("a tolerance").chords())
                .sum::<usize>()
        });
    });
    group.bench_function("cagd, uniform", |b| {
        b.iter(|| {
            let polylines = black_box(&curves)
                .iter()
                .map(|curve| curve.flattened_uniformly(TOLERANCE));
            polylines
                .map(|polyline| polyline.expect("a tolerance").chords())
                .sum::<usize>()
        });
    });
    let segments: Vec<_> = cubics()
        .into_iter()
        .map(|points| {
            let [from, ctrl1, ctrl2, to] = points.map(|[x, y]| lyon_geom::point(x, y));
            lyon_geom::CubicBezierSegment {
                from,
                ctrl1,
                ctrl2,
                to,
            }
        })
        .collect();
    group.bench_function("lyon_geom, collected", |b| {
        b.iter(|| {
            let polylines = black_box(&segments).iter().map(|segment| {
                let points: Vec<_> = segment.flattened(TOLERANCE).collect();
                points.len()
            });
            polylines.sum::<usize>()
        });
    });
    group.finish();
}

criterion_group!(benches, cubic_batch, high_degree, flattening);
criterion_main!(benches);
