//! Refinement of meshes beside the bound of any refinement: writing its result.
//!
//! What was measured, and how to read it, is in `README.md` beside this file.

use std::alloc::{GlobalAlloc, Layout, System};
use std::hint::black_box;
use std::sync::atomic::{AtomicUsize, Ordering};

use cagd::affine::Point;
use cagd::subdivision::{FastScheme, HalfEdgeMesh, Mesh, Refiner, StencilCascade, solids};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// The allocator of the system, which counts the bytes that are in use.
struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

impl Counting {
    fn more(bytes: usize) {
        let now = IN_USE.fetch_add(bytes, Ordering::Relaxed) + bytes;
        PEAK.fetch_max(now, Ordering::Relaxed);
    }

    fn less(bytes: usize) {
        IN_USE.fetch_sub(bytes, Ordering::Relaxed);
    }

    /// What `work` returns, and how many bytes at once it used in addition to those before.
    fn peak<R>(work: impl FnOnce() -> R) -> (R, usize) {
        let before = IN_USE.load(Ordering::Relaxed);
        PEAK.store(before, Ordering::Relaxed);
        let result = work();
        (result, PEAK.load(Ordering::Relaxed) - before)
    }
}

#[expect(
    unsafe_code,
    reason = "an allocator is unsafe by its interface; every call goes on to that of the system as it is"
)]
// SAFETY: all memory comes from `System` with the same layout, and goes back to it.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Self::more(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        Self::more(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // Both blocks may be there while one is copied to the other.
        Self::more(size);
        // SAFETY: as the caller promises.
        let moved = unsafe { System.realloc(memory, layout, size) };
        Self::less(layout.size());
        moved
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        Self::less(layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

type Space = Mesh<Point<f64, 3>>;

/// A torus with about this many triangles or quadrilaterals: nothing in it is extraordinary.
fn torus(scheme: FastScheme, faces: usize) -> Space {
    let cells = if scheme == FastScheme::Loop {
        faces / 2
    } else {
        faces
    };
    let rows = ((cells / 2) as f64).sqrt().round() as usize;
    let columns = cells / rows;
    let connectivity = match scheme {
        FastScheme::Loop => solids::torus_triangles(columns, rows),
        FastScheme::CatmullClark => solids::torus_quadrilaterals(columns, rows),
    };
    let points = solids::torus_points(columns, rows);
    Mesh::new(connectivity, points).expect("a point a vertex")
}

/// A ball with extraordinary vertices: an icosahedron or a cube, refined.
fn ball(scheme: FastScheme, steps: usize) -> Space {
    let start = match scheme {
        FastScheme::Loop => solids::icosahedron(),
        FastScheme::CatmullClark => solids::cube(),
    };
    Refiner::new(scheme)
        .refine(&start, steps)
        .expect("a small mesh")
        .clone()
}

/// How many steps lead from the solid of a [`ball`] to a million faces and more.
fn steps_to_a_million(scheme: FastScheme) -> usize {
    match scheme {
        FastScheme::Loop => 8,
        FastScheme::CatmullClark => 9,
    }
}

/// Refines a mesh, and returns how many points there are then.
fn refine(refiner: &mut Refiner, mesh: &Space, steps: usize) -> usize {
    let refined = refiner.refine(black_box(mesh), steps).expect("a mesh");
    black_box(refined.points().len())
}

fn name(scheme: FastScheme) -> &'static str {
    match scheme {
        FastScheme::Loop => "Loop",
        FastScheme::CatmullClark => "Catmull-Clark",
    }
}

const SCHEMES: [FastScheme; 2] = [FastScheme::Loop, FastScheme::CatmullClark];

/// How many bytes a mesh has: its points, three numbers a half-edge, one a vertex and one an edge.
fn bytes(mesh: &HalfEdgeMesh) -> usize {
    let numbers = 3 * mesh.half_edge_count() + mesh.vertex_count() + mesh.edge_count();
    4 * numbers + 24 * mesh.vertex_count()
}

/// How many bytes a step reads and writes if every list is counted once: the old mesh, the result, and what is summed up
/// around old vertices, which is written, added to and read; the new points once more when they are checked.
fn bytes_moved(old: &HalfEdgeMesh, refined: &HalfEdgeMesh) -> usize {
    let sums = 28 * old.vertex_count();
    bytes(old) + bytes(refined) + 3 * sums + 24 * refined.vertex_count()
}

/// Lists as long as those of a refined mesh.
struct Output {
    half_edges: [Vec<u32>; 3],
    vertex_half_edge: Vec<u32>,
    edge_half_edge: Vec<u32>,
    points: Vec<[f64; 3]>,
}

impl Output {
    fn like(mesh: &HalfEdgeMesh) -> Self {
        let list = || vec![0; mesh.half_edge_count()];
        Output {
            half_edges: [list(), list(), list()],
            vertex_half_edge: vec![0; mesh.vertex_count()],
            edge_half_edge: vec![0; mesh.edge_count()],
            points: vec![[0.0; 3]; mesh.vertex_count()],
        }
    }

    /// Writes every number once, in order.
    fn write(&mut self, number: u32) {
        for list in &mut self.half_edges {
            list.fill(number);
        }
        self.vertex_half_edge.fill(number);
        self.edge_half_edge.fill(number);
        self.points.fill([f64::from(number); 3]);
    }
}

/// One step to about a million faces, the memory of the result in place; and what writing the result alone takes.
fn step(c: &mut Criterion) {
    for scheme in SCHEMES {
        let mut group =
            c.benchmark_group(format!("one step to 1.3 million faces, {}", name(scheme)));
        let old = ball(scheme, steps_to_a_million(scheme) - 1);
        let mut refiner = Refiner::new(scheme);
        let refined = refiner
            .refine(&old, 1)
            .expect("a mesh")
            .connectivity()
            .clone();
        let faces = refined.face_count();
        let mut output = Output::like(&refined);
        println!(
            "{faces} faces; a face has {:.1} bytes, and {:.1} are moved for it",
            bytes(&refined) as f64 / faces as f64,
            bytes_moved(old.connectivity(), &refined) as f64 / faces as f64
        );
        drop(refined);
        group
            .throughput(Throughput::Elements(faces as u64))
            .sample_size(20);
        group.bench_function("writing the result", |b| {
            let mut number = 0;
            b.iter(|| {
                number += 1;
                output.write(black_box(number));
                black_box(&mut output.points);
            });
        });
        group.bench_function("refine", |b| {
            b.iter(|| refine(&mut refiner, &old, 1));
        });
        group.bench_function("refine, new memory", |b| {
            b.iter(|| refine(&mut Refiner::new(scheme), &old, 1));
        });
        let points = old.points().to_vec();
        let lists = old.connectivity().face_lists();
        group.bench_function("from lists of points and faces", |b| {
            // Lists of fixed length, as they come from a file or a buffer.
            if scheme == FastScheme::Loop {
                let faces: Vec<[u32; 3]> = lists.iter().map(|f| [f[0], f[1], f[2]]).collect();
                b.iter(|| from_lists(&mut refiner, &points, &faces));
            } else {
                let faces: Vec<[u32; 4]> = lists.iter().map(|f| [f[0], f[1], f[2], f[3]]).collect();
                b.iter(|| from_lists(&mut refiner, &points, &faces));
            }
        });
        group.finish();
    }
}

fn from_lists<F: AsRef<[u32]>>(
    refiner: &mut Refiner,
    points: &[Point<f64, 3>],
    faces: &[F],
) -> usize {
    let mesh = Mesh::from_faces(points.to_vec(), black_box(faces)).expect("a mesh");
    refine(refiner, &mesh, 1)
}

/// All steps from a solid, with the memory of the run before; the time counts for each face of the last step.
fn all_steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("all steps from a solid");
    for scheme in SCHEMES {
        let (start, steps) = (ball(scheme, 0), steps_to_a_million(scheme));
        let mut refiner = Refiner::new(scheme);
        let faces = refiner
            .refine(&start, steps)
            .expect("a mesh")
            .connectivity()
            .face_count();
        group
            .throughput(Throughput::Elements(faces as u64))
            .sample_size(20);
        group.bench_function(BenchmarkId::new(name(scheme), faces), |b| {
            b.iter(|| refine(&mut refiner, &start, steps));
        });
    }
    group.finish();
}

/// One step to 10³, 10⁴, …, 10⁷ faces.
fn sizes(c: &mut Criterion) {
    for scheme in SCHEMES {
        let mut group = c.benchmark_group(format!("one step, {}", name(scheme)));
        for exponent in 3..=7 {
            let old = torus(scheme, 10_usize.pow(exponent) / 4);
            let mut refiner = Refiner::new(scheme);
            let faces = refiner
                .refine(&old, 1)
                .expect("a mesh")
                .connectivity()
                .face_count();
            group
                .throughput(Throughput::Elements(faces as u64))
                .sample_size(10);
            group.bench_function(BenchmarkId::from_parameter(faces), |b| {
                b.iter(|| refine(&mut refiner, &old, 1));
            });
        }
        group.finish();
    }
}

/// Points alone, in single precision, for a connectivity that stays.
fn stencils(c: &mut Criterion) {
    let mut group = c.benchmark_group("points by stencils, f32");
    for scheme in SCHEMES {
        let old = ball(scheme, if scheme == FastScheme::Loop { 4 } else { 5 });
        let mut three = StencilCascade::<3>::new(scheme, old.connectivity(), 2).expect("a mesh");
        let mut four = StencilCascade::<4>::new(scheme, old.connectivity(), 2).expect("a mesh");
        let faces = three.connectivity().face_count();
        let control3: Vec<[f32; 3]> = old
            .points()
            .iter()
            .map(|p| [p[0] as f32, p[1] as f32, p[2] as f32])
            .collect();
        let control4: Vec<[f32; 4]> = control3.iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect();
        group
            .throughput(Throughput::Elements(faces as u64))
            .sample_size(20);
        group.bench_function(
            BenchmarkId::new(format!("{}, 3 coordinates", name(scheme)), faces),
            |b| {
                b.iter(|| black_box(three.apply(black_box(&control3)).expect("points").len()));
            },
        );
        group.bench_function(
            BenchmarkId::new(format!("{}, 4 coordinates", name(scheme)), faces),
            |b| {
                b.iter(|| black_box(four.apply(black_box(&control4)).expect("points").len()));
            },
        );
    }
    group.finish();
}

/// The memory that is in use at once, beside the bytes of the result: at most three times as much.
fn memory(_: &mut Criterion) {
    for scheme in SCHEMES {
        let steps = steps_to_a_million(scheme);
        let [start, old] = [0, steps - 1].map(|steps| ball(scheme, steps));
        let report = |what: &str, peak: usize, refined: &HalfEdgeMesh| {
            let ratio = peak as f64 / bytes(refined) as f64;
            println!(
                "{}, {what}: {ratio:.2} times the result in use",
                name(scheme)
            );
            assert!(ratio <= 3.0, "{what} needs too much memory");
        };
        let lists = old.connectivity().face_lists();
        let (refiner, peak) = Counting::peak(|| {
            let mesh = Mesh::from_faces(old.points().to_vec(), &lists).expect("a mesh");
            let mut refiner = Refiner::new(scheme);
            refine(&mut refiner, &mesh, 1);
            refiner
        });
        let refined = refiner.levels()[0].connectivity().clone();
        drop(refiner);
        report(
            "one step from lists, the mesh of the lists included",
            peak,
            &refined,
        );
        for (what, mesh, steps) in [("one step", &old, 1), ("all steps", &start, steps)] {
            let mut refiner = Refiner::new(scheme);
            let (_, peak) = Counting::peak(|| refine(&mut refiner, mesh, steps));
            report(what, peak, &refined);
        }
    }
}

criterion_group!(benches, memory, step, all_steps, sizes, stencils);
criterion_main!(benches);
