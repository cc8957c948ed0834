//! `subdivide` on meshes that a reader brings.

use std::fs;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;
use std::path::PathBuf;
use std::process::Command;

use tempfile::TempDir;

use super::house::Run;

const OCTAHEDRON: &str = "# an octahedron\n\
    v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
    f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
const CUBE: &str = "OFF\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
    4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// A folder with an octahedron and a cube; no workbook is there, and none is needed.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        folder.write("octahedron.obj", OCTAHEDRON);
        folder.write("cube.off", CUBE);
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

    fn run(&self, arguments: &str) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        command
            .arg("subdivide")
            .args(arguments.split(' '))
            .current_dir(self.0.path());
        Run::of(command)
    }

    /// The command fails with these words and leaves no file behind.
    #[track_caller]
    fn refuses(&self, arguments: &str, words: &[&str]) {
        let files = || {
            let entries = fs::read_dir(self.0.path()).expect("a folder");
            let mut names: Vec<_> = entries.map(|e| e.expect("an entry").file_name()).collect();
            names.sort();
            names
        };
        let before = files();
        let run = self.run(arguments);
        run.assert_status(2);
        for word in words {
            run.assert_says(word);
        }
        assert_eq!(files(), before, "{run:#?}");
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
}

#[test]
fn every_scheme_and_every_format_is_there() {
    let folder = Folder::new();
    for (arguments, says) in [
        (
            "octahedron.obj --scheme butterfly -o butterfly.off",
            "18 vertices, 48 edges and 32 faces",
        ),
        (
            "cube.off --scheme catmull-clark -o smooth.ply",
            "26 vertices, 48 edges and 24 faces",
        ),
        (
            "cube.off --scheme doo-sabin -o cut.obj",
            "24 vertices, 48 edges and 26 faces",
        ),
        (
            "smooth.ply --scheme kobbelt -o kobbelt.OBJ",
            "98 vertices, 192 edges and 96 faces",
        ),
        (
            "kobbelt.OBJ --scheme kobbelt --steps 0 --format ply-binary -o kobbelt.ply",
            "98 vertices",
        ),
        (
            "kobbelt.ply --scheme kobbelt --steps 0 -o again.obj",
            "98 vertices",
        ),
    ] {
        let run = folder.run(arguments);
        run.assert_status(0);
        run.assert_says(says);
    }
    assert!(folder.read("kobbelt.ply").contains("binary_little_endian"));
    assert_eq!(folder.read("again.obj"), folder.read("kobbelt.OBJ"));
}

#[test]
fn vertices_move_to_the_limit() {
    let folder = Folder::new();
    let run = folder.run("octahedron.obj --scheme loop --steps 0 --limit -o limit.obj");
    run.assert_status(0);
    let text = folder.read("limit.obj");
    let x: f64 = text
        .split_whitespace()
        .nth(1)
        .and_then(|word| word.parse().ok())
        .expect("the first coordinate");
    // 24/55 is the weight of the vertex against its four neighbours, which cancel.
    assert!((x - 24.0 / 55.0).abs() < 1e-15, "{x}");
    folder
        .run("cube.off --scheme catmull-clark --limit -o limit.off")
        .assert_status(0);
    // A corner of a cube goes half the way to the centre; these numbers are without rounding.
    let corner = folder.read("limit.off");
    assert_eq!(corner.lines().nth(2), Some("0.25 0.25 0.25"), "{corner}");
    folder.refuses(
        "octahedron.obj --scheme butterfly --limit -o out.obj",
        &["--limit", "next step"],
    );
}

#[test]
fn standard_output_takes_the_mesh() {
    let folder = Folder::new();
    let run = folder.run("octahedron.obj --scheme loop -o - --format obj");
    run.assert_status(0);
    assert_eq!(counts(&run.stdout), [18, 32]);
    assert!(
        run.stderr.contains("18 vertices, 48 edges and 32 faces"),
        "{run:?}"
    );
    folder.refuses("octahedron.obj --scheme loop -o -", &["--format"]);
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
    folder.write(
        "open.off",
        "OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
    );
    folder.refuses(
        "open.off --scheme kobbelt -o out.obj",
        &["`open.off`, line 3: ", "boundary"],
    );
}

#[test]
fn too_many_steps_are_counted_first() {
    let folder = Folder::new();
    folder.refuses(
        "octahedron.obj --scheme loop --steps 11 -o out.obj",
        &[
            "11 steps would give 33554432 faces",
            "at most 16000000",
            "next step: `--steps 10` gives 8388608; or allow more with `--max-faces`",
        ],
    );
    folder.refuses(
        "octahedron.obj --scheme loop --steps 3 --max-faces 100 -o out.obj",
        &["would give 512 faces", "`--steps 1` gives 32"],
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
