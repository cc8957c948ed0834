//! `cargo run -- subdivide`: refines a mesh from a file.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::{Args, ValueEnum, value_parser};
use thiserror::Error;

use crate::affine::Point;
use crate::subdivision::files::{MeshFile, MeshFileError, Place};
use crate::subdivision::{
    Butterfly, CatmullClark, DooSabin, FaceId, Kobbelt, Loop, Mesh, Refinement, SchemeError,
    SurfaceScheme,
};
use crate::workbook::command_line::Outcome;
use crate::workbook::durable;
use crate::workbook::feedback::patience::patiently;
use crate::workbook::mesh_files::{MeshFormat, Space};

/// The arguments of `subdivide`.
#[derive(Debug, Args)]
pub struct Subdivide {
    /// The mesh: a file in the format OBJ, OFF or PLY, as its ending tells
    #[arg(value_name = "FILE")]
    input: PathBuf,
    /// The scheme
    #[arg(long)]
    scheme: Scheme,
    /// How many times the mesh is refined
    #[arg(long, default_value_t = 1, value_parser = value_parser!(u32).range(0..=MOST_STEPS))]
    steps: u32,
    /// Move every vertex to its place on the limit surface in the end (loop and catmull-clark)
    #[arg(long)]
    limit: bool,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "FILE")]
    out: PathBuf,
    /// The format to write, instead of that which the ending of the file tells
    #[arg(long)]
    format: Option<MeshFormat>,
    /// Write over a file that is there
    #[arg(long)]
    force: bool,
    /// Refuse results with more faces than this; a million faces take 100 to 250 MB of memory
    #[arg(long, value_name = "FACES", default_value_t = 16_000_000)]
    max_faces: u64,
}

/// The schemes by their names on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Scheme {
    /// Loop's scheme, for triangles
    Loop,
    /// The modified Butterfly scheme, for triangles; keeps the vertices
    Butterfly,
    /// The scheme of Catmull and Clark, for any polygons
    CatmullClark,
    /// The scheme of Doo and Sabin, for any polygons
    DooSabin,
    /// Kobbelt's scheme, for closed meshes of quadrilaterals; keeps the vertices
    Kobbelt,
}

impl Scheme {
    fn rules(self) -> Box<dyn SurfaceScheme<Point<f64, 3>>> {
        match self {
            Self::Loop => Box::new(Loop),
            Self::Butterfly => Box::new(Butterfly::MODIFIED),
            Self::CatmullClark => Box::new(CatmullClark),
            Self::DooSabin => Box::new(DooSabin),
            Self::Kobbelt => Box::new(Kobbelt),
        }
    }

    fn refinement(self) -> Refinement {
        match self {
            Self::Loop | Self::Butterfly => Refinement::Triangles,
            Self::CatmullClark | Self::Kobbelt => Refinement::Quadrilaterals,
            Self::DooSabin => Refinement::CutCorners,
        }
    }

    /// How many vertices all faces must have.
    fn face_degree(self) -> Option<usize> {
        match self {
            Self::Loop | Self::Butterfly => Some(3),
            Self::Kobbelt => Some(4),
            Self::CatmullClark | Self::DooSabin => None,
        }
    }

    /// The rule that moves all vertices to the limit surface, if the scheme has one.
    fn limit(self) -> Option<LimitRule> {
        match self {
            Self::Loop => Some(|mesh| {
                let vertices = mesh.connectivity().vertices();
                vertices.map(|v| Loop.limit_point(mesh, v)).collect()
            }),
            Self::CatmullClark => Some(|mesh| {
                let vertices = mesh.connectivity().vertices();
                vertices
                    .map(|v| CatmullClark.limit_position(mesh, v))
                    .collect()
            }),
            Self::Butterfly | Self::Kobbelt | Self::DooSabin => None,
        }
    }
}

/// Where the vertices of a mesh go in the limit.
type LimitRule = fn(&Space) -> Result<Vec<Point<f64, 3>>, SchemeError>;

/// Why a mesh is not refined.
#[derive(Debug, Error)]
pub enum SubdivideError {
    /// The ending of a file name tells no format.
    #[error(
        "the format of `{}` is not known\nnext step: {next_step}",
        file.display()
    )]
    Format {
        /// The file.
        file: PathBuf,
        /// What to do.
        next_step: &'static str,
    },
    /// The mesh cannot be read.
    #[error("`{}` cannot be read ({reason})\nnext step: name a file that holds a mesh", file.display())]
    Input {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        reason: io::Error,
    },
    /// The file is no mesh.
    #[error("`{}`, {error}", file.display())]
    Broken {
        /// The file.
        file: PathBuf,
        /// Why, with the line.
        error: MeshFileError,
    },
    /// The scheme has no rule for this mesh.
    #[error("`{}`{}: {error}\nnext step: {next_step}", file.display(), at(*place))]
    Scheme {
        /// The file.
        file: PathBuf,
        /// Where the element stands that is named.
        place: Option<Place>,
        /// Why not.
        error: SchemeError,
        /// What to do.
        next_step: &'static str,
    },
    /// A later step fails.
    #[error(
        "step {step} cannot be done: {error}\nnext step: take fewer steps or another `--scheme`"
    )]
    Step {
        /// Which step.
        step: u32,
        /// Why not.
        error: SchemeError,
    },
    /// The scheme has no limit rules.
    #[error(
        "`--limit` is for the schemes loop and catmull-clark only\nnext step: leave it out, or change `--scheme`"
    )]
    NoLimit,
    /// The result is too large.
    #[error(
        "{steps} steps would give {}{faces} faces, and at most {most} are made\n\
         next step: {next_step}",
        .up_to
    )]
    TooLarge {
        /// How many steps were asked for.
        steps: u32,
        /// How many faces there would be.
        faces: u128,
        /// Said before a number that is an upper bound.
        up_to: &'static str,
        /// How many there may be.
        most: u64,
        /// What to do.
        next_step: String,
    },
    /// The result would be written over the mesh that was read.
    #[error("`{}` is the mesh that is read\nnext step: name another file with `--out`", .0.display())]
    SameFile(PathBuf),
    /// There is a file already.
    #[error("`{}` is there already\nnext step: name another file with `--out`, or write over it with `--force`", .0.display())]
    Exists(PathBuf),
    /// The result cannot be written.
    #[error("`{}` cannot be written ({reason})\nnext step: name a file in a folder that is yours", file.display())]
    Output {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        reason: io::Error,
    },
    /// Standard output is closed.
    #[error("cannot write the answer: {0}")]
    Answer(#[from] io::Error),
}

fn at(place: Option<Place>) -> String {
    place.map_or_else(String::new, |place| format!(", {place}"))
}

/// A quadrilateral has at most eight half-edges, if no edge is shared, and the numbers of half-edges have 32 bits.
const MOST_FACES: u64 = u32::MAX as u64 / 8;

/// With more steps even one triangle would have more faces than there are numbers for.
const MOST_STEPS: i64 = 40;

impl Subdivide {
    /// Reads, refines and writes.
    ///
    /// # Errors
    ///
    /// The file is no mesh, the scheme has no rule for it, the result is too large or cannot be written.
    pub(crate) fn run(self) -> Result<Outcome, SubdivideError> {
        let reads = MeshFormat::of(&self.input).ok_or_else(|| SubdivideError::Format {
            file: self.input.clone(),
            next_step: "give it the ending .obj, .off or .ply",
        })?;
        let writes = self.format.or_else(|| MeshFormat::of(&self.out));
        let writes = writes.ok_or_else(|| SubdivideError::Format {
            file: self.out.clone(),
            next_step: "name it with `--format obj`, `off`, `ply` or `ply-binary`",
        })?;
        let limit = match self.limit {
            true => Some(self.scheme.limit().ok_or(SubdivideError::NoLimit)?),
            false => None,
        };
        if !self.to_standard_output() {
            self.must_be_writable()?;
        }
        let file = self.read(reads)?;
        for dropped in file.dropped() {
            eprintln!("warning: `{}`: {dropped}", self.input.display());
        }
        self.must_suit(&file)?;
        let refined = self.refined(&file, limit)?;
        self.write(&refined, writes)?;
        let mesh = refined.connectivity();
        let counts = format!(
            "{} vertices, {} edges and {} faces",
            mesh.vertex_count(),
            mesh.edge_count(),
            mesh.face_count()
        );
        if self.to_standard_output() {
            eprintln!("{counts}");
        } else {
            writeln!(io::stdout(), "`{}` has {counts}.", self.out.display())?;
        }
        Ok(Outcome::Fine)
    }

    fn to_standard_output(&self) -> bool {
        self.out.as_os_str() == "-"
    }

    /// Tries whether the file can be written, before anybody waits for what it will hold.
    fn must_be_writable(&self) -> Result<(), SubdivideError> {
        let same = fs::canonicalize(&self.out)
            .ok()
            .zip(fs::canonicalize(&self.input).ok());
        if same.is_some_and(|(out, input)| out == input) {
            return Err(SubdivideError::SameFile(self.out.clone()));
        }
        // A device such as `/dev/null` must not be replaced by a file.
        if fs::metadata(&self.out).is_ok_and(|there| !there.is_file()) {
            return Err(self.not_written(io::Error::other("it is a folder or a device")));
        }
        if self.out.exists() && !self.force {
            return Err(SubdivideError::Exists(self.out.clone()));
        }
        durable::try_new(&self.out).map_err(|reason| self.not_written(reason))
    }

    fn not_written(&self, reason: io::Error) -> SubdivideError {
        SubdivideError::Output {
            file: self.out.clone(),
            reason,
        }
    }

    fn read(&self, format: MeshFormat) -> Result<MeshFile, SubdivideError> {
        patiently(&format!("reading {}", self.input.display()), || {
            let bytes = fs::read(&self.input).map_err(|reason| SubdivideError::Input {
                file: self.input.clone(),
                reason,
            })?;
            format.read(&bytes).map_err(|error| SubdivideError::Broken {
                file: self.input.clone(),
                error,
            })
        })
    }

    /// The scheme has rules for the faces, and the result is not too large.
    fn must_suit(&self, file: &MeshFile) -> Result<(), SubdivideError> {
        let mesh = file.mesh().connectivity();
        let degree_of = |f: FaceId| mesh.face_degree(f);
        if let Some(expected) = self.scheme.face_degree()
            && let Some(face) = mesh.faces().find(|&f| degree_of(f) != expected)
        {
            let error = SchemeError::FaceDegree {
                scheme: self.scheme.rules().name(),
                face,
                expected,
                found: degree_of(face),
            };
            return Err(self.no_rule(file, error));
        }
        let refinement = self.scheme.refinement();
        let most = self.max_faces.min(MOST_FACES);
        let fits = |steps: u32| {
            let [_, _, faces] = refinement.counts_after(mesh, steps);
            (faces <= u128::from(most)).then_some(faces)
        };
        if fits(self.steps).is_some() {
            return Ok(());
        }
        // Numbers grow at least twofold, so few steps are tried.
        let possible = (0..self.steps).map_while(|steps| Some((steps, fits(steps)?)));
        let fewer = possible.last();
        let fewer = fewer.map(|(steps, faces)| format!("`--steps {steps}` gives {faces}"));
        let more = (most < MOST_FACES).then(|| "allow more with `--max-faces`".to_owned());
        let ways: Vec<String> = fewer.into_iter().chain(more).collect();
        let bounds = refinement == Refinement::CutCorners && !mesh.is_closed();
        Err(SubdivideError::TooLarge {
            steps: self.steps,
            faces: refinement.counts_after(mesh, self.steps)[2],
            up_to: if bounds { "up to " } else { "" },
            most,
            next_step: match ways.is_empty() {
                true => "take a mesh with fewer faces".to_owned(),
                false => ways.join("; or "),
            },
        })
    }

    /// A refusal of the mesh that was read, with the place of the element in the file.
    fn no_rule(&self, file: &MeshFile, error: SchemeError) -> SubdivideError {
        let place = match &error {
            SchemeError::FaceDegree { face, .. } => file.face_place(*face),
            SchemeError::Valence { vertex, .. } | SchemeError::Boundary { vertex, .. } => {
                file.vertex_place(*vertex)
            }
            _ => None,
        };
        SubdivideError::Scheme {
            file: self.input.clone(),
            place,
            error,
            next_step: "change the mesh there, or choose another `--scheme`; \
                        `catmull-clark` takes faces with any number of vertices, also at a boundary",
        }
    }

    fn refined(&self, file: &MeshFile, limit: Option<LimitRule>) -> Result<Space, SubdivideError> {
        let rules = self.scheme.rules();
        let mut refined = file.mesh().clone();
        for step in 1..=self.steps {
            let [_, _, faces] = self
                .scheme
                .refinement()
                .counts_after(refined.connectivity(), 1);
            let what = format!("step {step} of {}, to {faces} faces", self.steps);
            let next = patiently(&what, || rules.refine(&refined));
            refined = next.map_err(|error| match step {
                1 => self.no_rule(file, error),
                _ => SubdivideError::Step { step, error },
            })?;
        }
        let Some(limit) = limit else {
            return Ok(refined);
        };
        let moved = patiently("moving the vertices to the limit", || {
            let points = limit(&refined)?;
            let mesh = Mesh::new(refined.connectivity().clone(), points);
            mesh.map_err(SchemeError::from)
        });
        moved.map_err(|error| match self.steps {
            0 => self.no_rule(file, error),
            step => SubdivideError::Step { step, error },
        })
    }

    fn write(&self, mesh: &Space, format: MeshFormat) -> Result<(), SubdivideError> {
        if self.to_standard_output() {
            let mut out = io::BufWriter::new(io::stdout().lock());
            format.write(mesh, &mut out)?;
            out.flush()?;
            return Ok(());
        }
        patiently(&format!("writing {}", self.out.display()), || {
            durable::write_new(&self.out, self.force, |out| format.write(mesh, out))
        })
        .map_err(|reason| match reason.kind() {
            io::ErrorKind::AlreadyExists => SubdivideError::Exists(self.out.clone()),
            _ => self.not_written(reason),
        })
    }
}
