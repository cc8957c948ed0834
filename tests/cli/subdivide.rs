//! `subdivide` on meshes that a reader brings.

use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;
use std::path::PathBuf;
use std::process::Command;

use cagd::affine::Point;
use cagd::subdivision::{Butterfly, CatmullClark, DooSabin, Kobbelt, Loop, SurfaceScheme};
use cagd::workbook::mesh_files::{MeshFormat, Space};
use tempfile::TempDir;

use super::house::Run;

const OCTAHEDRON: &str = "# an octahedron\n\
    v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
    f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
const CUBE: &str = "OFF\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
    4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
const SQUARE: &str = "OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// A folder with an octahedron, a cube and a square; no workbook is there, and none is needed.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        folder.write("octahedron.obj", OCTAHEDRON);
        folder.write("cube.off", CUBE);
        folder.write("square.off", SQUARE);
        folder
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    #[track_caller]
    fn write(&self, file: &str, text: &str) {
        fs::write(self.path(file), text).expect("a file can be written");
    }

    #[track_caller]
    fn read(&self, file: &str) -> String {
        let bytes = fs::read(self.path(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        String::from_utf8_lossy(&bytes).into_owned()
    }

    /// The mesh in a file.
    #[track_caller]
    fn mesh(&self, file: &str) -> Space {
        let path = self.path(file);
        let format = MeshFormat::of(&path).expect("an ending that is known");
        let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{file}: {error}"));
        let read = format.read(&bytes);
        let read = read.unwrap_or_else(|error| panic!("{file}, {error}"));
        read.mesh().clone()
    }

    /// The names of all files, sorted.
    fn files(&self) -> Vec<OsString> {
        let entries = fs::read_dir(self.0.path()).expect("a folder");
        let mut names: Vec<_> = entries.map(|e| e.expect("an entry").file_name()).collect();
        names.sort();
        names
    }

    fn run(&self, arguments: &str) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        command
            .arg("subdivide")
            .args(arguments.split(' '))
            .current_dir(self.0.path())
            // It would lead to the workbook.
            .env_remove("CARGO_MANIFEST_DIR");
        Run::of(command)
    }

    /// The command fails with these words and leaves no file behind.
    #[track_caller]
    fn refuses(&self, arguments: &str, words: &[&str]) {
        let before = self.files();
        let run = self.run(arguments);
        run.assert_status(2);
        for word in words {
            run.assert_says(word);
        }
        assert_eq!(self.files(), before, "{run:#?}");
    }
}

/// The numbers of vertices and faces of a text in the format OBJ.
fn counts(text: &str) -> [usize; 2] {
    ["v ", "f "].map(|begin| text.lines().filter(|line| line.starts_with(begin)).count())
}

#[test]
fn a_mesh_is_refined() {
    let folder = Folder::new();
    let run = folder.run("octahedron.obj --scheme loop --steps 2 -o fine.obj");
    run.assert_status(0);
    run.assert_says("`fine.obj` has 66 vertices, 192 edges and 128 faces.");
    assert!(!run.stderr.contains("warning"), "{run:#?}");
    assert_eq!(counts(&folder.read("fine.obj")), [66, 128]);
    let files = ["cube.off", "fine.obj", "octahedron.obj", "square.off"];
    assert_eq!(folder.files(), files);
}

#[test]
fn every_scheme_refines_by_its_own_rules() {
    let folder = Folder::new();
    let schemes: [(&str, &str, &dyn SurfaceScheme<Point<f64, 3>>); 5] = [
        ("octahedron.obj", "loop", &Loop),
        ("loop.ply", "butterfly", &Butterfly::MODIFIED),
        ("cube.off", "catmull-clark", &CatmullClark),
        ("cube.off", "doo-sabin", &DooSabin),
        ("catmull-clark.ply", "kobbelt", &Kobbelt),
    ];
    for (input, scheme, rules) in schemes {
        let out = format!("{scheme}.ply");
        let run = folder.run(&format!("{input} --scheme {scheme} -o {out}"));
        run.assert_status(0);
        let expected = rules.refine(&folder.mesh(input)).expect("a rule");
        let found = folder.mesh(&out);
        assert_eq!(found.points(), expected.points(), "{scheme}");
        let faces = |mesh: &Space| mesh.connectivity().face_lists();
        assert_eq!(faces(&found), faces(&expected), "{scheme}");
        // The number of faces is known before the work begins.
        let most = expected.connectivity().face_count() - 1;
        folder.refuses(
            &format!("{input} --scheme {scheme} --max-faces {most} -o no.ply"),
            &[&format!("would give {} faces", most + 1)],
        );
    }
    // At a boundary the scheme of Doo and Sabin gives fewer.
    folder.refuses(
        "square.off --scheme doo-sabin --max-faces 1 -o no.ply",
        &["would give up to 9 faces", "`--steps 0` gives 1"],
    );
}

#[test]
fn every_format_is_read_and_written() {
    let folder = Folder::new();
    let mut input = "octahedron.obj";
    for (options, out, begin) in [
        ("", "a.off", "OFF\n"),
        ("", "b.ply", "ply\nformat ascii"),
        (
            " --format ply-binary",
            "c.ply",
            "ply\nformat binary_little_endian",
        ),
        ("", "D.OBJ", "v "),
        // The format that is asked for, whatever the ending says.
        (" --format off", "e.obj", "OFF\n"),
    ] {
        let run = folder.run(&format!(
            "{input} --scheme loop --steps 0{options} -o {out}"
        ));
        run.assert_status(0);
        let text = folder.read(out);
        assert!(text.starts_with(begin), "{out}: {text}");
        input = out;
    }
    assert_eq!(folder.mesh("D.OBJ"), folder.mesh("octahedron.obj"));
    assert_eq!(folder.read("e.obj"), folder.read("a.off"));
}

#[test]
fn vertices_move_to_the_limit() {
    let folder = Folder::new();
    for (input, scheme, place) in [
        // The weight of the vertex against its four neighbours, which cancel.
        ("octahedron.obj", "loop", 24.0 / 55.0),
        // At valence 3 the weights are 9 : 4 : 1; two of the opposite vertices have x = 1, and one of the neighbours.
        ("cube.off", "catmull-clark", (4.0 + 2.0) / 24.0),
    ] {
        // A step does not move the limit.
        for steps in [0, 2] {
            let run = folder.run(&format!(
                "{input} --scheme {scheme} --steps {steps} --limit --force -o limit.off"
            ));
            run.assert_status(0);
            let x = folder.mesh("limit.off").points()[0][0];
            // Some ten sums of numbers up to 1, each rounded by at most 1.1e-16.
            assert!((x - place).abs() < 1e-15, "{scheme}, {steps} steps: {x}");
        }
    }
    folder.refuses(
        "octahedron.obj --scheme butterfly --limit -o out.obj",
        &["`--limit` is for", "next step"],
    );
    // The rule for limits needs quadrilaterals; a step makes them.
    folder.refuses(
        "octahedron.obj --scheme catmull-clark --steps 0 --limit -o out.obj",
        &[
            "`octahedron.obj`, line ",
            "faces with 4 vertices",
            "next step",
        ],
    );
}

#[test]
fn standard_output_takes_the_mesh() {
    let folder = Folder::new();
    let run = folder.run("octahedron.obj --scheme loop -o - --format obj");
    run.assert_status(0);
    assert!(
        run.stderr.contains("18 vertices, 48 edges and 32 faces"),
        "{run:?}"
    );
    folder
        .run("octahedron.obj --scheme loop -o out.obj")
        .assert_status(0);
    assert_eq!(run.stdout, folder.read("out.obj"));
    folder.refuses("octahedron.obj --scheme loop -o -", &["`-`", "--format"]);
}

#[test]
fn a_file_of_an_old_mac_is_read() {
    let folder = Folder::new();
    folder.write("mac.obj", &OCTAHEDRON.replace('\n', "\r"));
    folder
        .run("mac.obj --scheme loop -o out.obj")
        .assert_status(0);
    assert_eq!(counts(&folder.read("out.obj")), [18, 32]);
}

#[test]
fn what_is_dropped_is_told() {
    let folder = Folder::new();
    folder.write(
        "named.obj",
        &format!("o ball\n{OCTAHEDRON}vn 0 0 1\nv 9 9 9\n"),
    );
    let run = folder.run("named.obj --scheme loop -o out.obj");
    run.assert_status(0);
    run.assert_says("warning: `named.obj`: groups and objects are left out: 1, from line 1 on");
    run.assert_says("normals are left out: 1, from line 17 on");
    run.assert_says("vertices without a face are left out: 1, from line 18 on");
    assert_eq!(counts(&folder.read("out.obj")), [18, 32]);
}

#[test]
fn a_broken_file_is_refused_with_its_line_and_the_reason() {
    let folder = Folder::new();
    folder.write("broken.obj", &OCTAHEDRON.replace("v 0 1 0", "v 0 1 O"));
    folder.refuses(
        "broken.obj --scheme loop -o out.obj",
        &["`broken.obj`, line 4: expected a number, found `O`"],
    );
    folder.write("turned.obj", &OCTAHEDRON.replace("f 2 4 5", "f 2 5 4"));
    folder.refuses(
        "turned.obj --scheme loop -o out.obj",
        &[
            "`turned.obj`, line 10: ",
            "opposite directions",
            "face 1: line 9",
        ],
    );
    folder.write("empty.ply", "");
    folder.refuses(
        "empty.ply --scheme loop -o out.obj",
        &["`empty.ply`, line 1: expected `ply`"],
    );
    folder.refuses(
        "nothing.obj --scheme loop -o out.obj",
        &["`nothing.obj` cannot be read", "next step"],
    );
    folder.refuses(
        "octahedron.stl --scheme loop -o out.obj",
        &["`octahedron.stl`", ".obj, .off or .ply"],
    );
}

#[test]
fn a_scheme_without_a_rule_names_the_line() {
    let folder = Folder::new();
    folder.refuses(
        "cube.off --scheme loop -o out.obj",
        &[
            "`cube.off`, line 11: Loop's scheme needs faces with 3 vertices, but face 0 has 4",
            "catmull-clark",
        ],
    );
    folder.refuses(
        "octahedron.obj --scheme kobbelt -o out.obj",
        &["line 8", "faces with 4 vertices"],
    );
    // Two extraordinary vertices in a face.
    folder.refuses(
        "cube.off --scheme kobbelt -o out.obj",
        &["`cube.off`, line ", "extraordinary"],
    );
    folder.refuses(
        "square.off --scheme kobbelt -o out.obj",
        &["`square.off`, line 3: ", "boundary"],
    );
}

#[test]
fn a_later_step_that_fails_is_named() {
    let folder = Folder::new();
    // The points of the first step reach 5/4 of the largest coordinate, those of the second one 83/64: more than f64 holds.
    let far = [1.4e308, 1.4e308, 1.4e308, -1.4e308, 1.4e308, -1.4e308];
    let vertices = far.iter().enumerate();
    let mut mesh: String = vertices.map(|(y, x)| format!("v {x:e} {y} 0\n")).collect();
    mesh.push_str(&OCTAHEDRON[OCTAHEDRON.find("f ").expect("a face")..]);
    folder.write("far.obj", &mesh);
    folder
        .run("far.obj --scheme butterfly -o one.obj")
        .assert_status(0);
    folder.refuses(
        "far.obj --scheme butterfly --steps 2 -o two.obj",
        &["step 2 cannot be done: ", "not finite", "next step"],
    );
}

#[test]
fn too_many_steps_are_counted_first() {
    let folder = Folder::new();
    folder.refuses(
        "octahedron.obj --scheme loop --steps 3 --max-faces 100 -o out.obj",
        &["would give 512 faces", "`--steps 1` gives 32"],
    );
    folder.refuses(
        "octahedron.obj --scheme loop --steps 11 -o out.obj",
        &[
            "11 steps would give 33554432 faces",
            "at most 16000000",
            "next step: `--steps 10` gives 8388608; or allow more with `--max-faces`",
        ],
    );
    folder.refuses(
        "octahedron.obj --scheme loop --steps 40 --max-faces 18446744073709551615 -o out.obj",
        &[
            "9671406556917033397649408 faces",
            "at most 536870911",
            "next step: `--steps 12` gives 134217728\n",
        ],
    );
    folder.refuses(
        "octahedron.obj --scheme loop --steps 0 --max-faces 7 -o out.obj",
        &["would give 8 faces", "next step: allow more with"],
    );
    folder.refuses(
        "octahedron.obj --scheme loop --steps 41 -o out.obj",
        &["0..=40"],
    );
}

#[test]
fn no_file_is_lost() {
    let folder = Folder::new();
    folder.write("out.obj", "precious");
    folder.refuses(
        "octahedron.obj --scheme loop -o out.obj",
        &["`out.obj` is there already", "--force"],
    );
    assert_eq!(folder.read("out.obj"), "precious");
    // It is told before anything is read.
    folder.refuses(
        "nothing.obj --scheme loop -o out.obj",
        &["`out.obj` is there already"],
    );
    folder.refuses(
        "nothing.obj --scheme loop -o no/such/out.obj",
        &["`no/such/out.obj` cannot be written"],
    );
    folder
        .run("octahedron.obj --scheme loop --force -o out.obj")
        .assert_status(0);
    assert_eq!(counts(&folder.read("out.obj")), [18, 32]);
    folder.refuses(
        "octahedron.obj --scheme loop --force -o ./octahedron.obj",
        &["is the mesh that is read", "next step"],
    );
    assert_eq!(folder.read("octahedron.obj"), OCTAHEDRON);
    folder.refuses(
        "octahedron.obj --scheme loop -o no/such/out.obj",
        &["cannot be written", "next step"],
    );
    let _socket = UnixListener::bind(folder.path("socket.obj")).expect("a socket");
    folder.refuses(
        "octahedron.obj --scheme loop --force -o socket.obj",
        &["`socket.obj` cannot be written (it is a folder or a device)"],
    );
    fs::create_dir(folder.path("folder.obj")).expect("a folder");
    folder.refuses(
        "octahedron.obj --scheme loop --force -o folder.obj",
        &["cannot be written"],
    );
}

#[test]
fn the_file_behind_a_link_is_written() {
    let folder = Folder::new();
    fs::create_dir(folder.path("meshes")).expect("a folder");
    folder.write("meshes/fine.obj", "precious");
    symlink("meshes/fine.obj", folder.path("link.obj")).expect("a link");
    symlink("link.obj", folder.path("twice.obj")).expect("a link");
    folder.refuses(
        "octahedron.obj --scheme loop -o twice.obj",
        &["`twice.obj` is there already", "--force"],
    );
    assert_eq!(folder.read("meshes/fine.obj"), "precious");
    let is_link = |file: &str| folder.path(file).is_symlink();
    folder
        .run("octahedron.obj --scheme loop --force -o twice.obj")
        .assert_status(0);
    assert!(is_link("twice.obj") && is_link("link.obj"));
    assert_eq!(counts(&folder.read("meshes/fine.obj")), [18, 32]);

    // A link whose file is not there yet says where the new file goes.
    fs::remove_file(folder.path("meshes/fine.obj")).expect("a file");
    folder
        .run("octahedron.obj --scheme loop -o link.obj")
        .assert_status(0);
    assert!(is_link("link.obj") && !is_link("meshes/fine.obj"));
    assert_eq!(counts(&folder.read("meshes/fine.obj")), [18, 32]);

    symlink("itself.obj", folder.path("itself.obj")).expect("a link");
    folder.refuses(
        "octahedron.obj --scheme loop --force -o itself.obj",
        &["`itself.obj` cannot be written (it is a link that leads to no file)"],
    );
    symlink("octahedron.obj", folder.path("input.obj")).expect("a link");
    folder.refuses(
        "octahedron.obj --scheme loop --force -o input.obj",
        &["is the mesh that is read"],
    );
    assert_eq!(folder.read("octahedron.obj"), OCTAHEDRON);
}

#[test]
fn the_result_is_a_file_like_any_other() {
    use std::os::unix::fs::PermissionsExt;

    let folder = Folder::new();
    folder
        .run("octahedron.obj --scheme loop -o out.obj")
        .assert_status(0);
    let rights = |file: &str| {
        fs::metadata(folder.path(file))
            .expect("it is there")
            .permissions()
            .mode()
    };
    assert_eq!(rights("out.obj"), rights("octahedron.obj"));
}
