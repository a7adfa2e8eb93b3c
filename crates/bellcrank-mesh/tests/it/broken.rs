//! Broken files: every error has its place, and nothing panics.

use bellcrank_mesh::{FileFault, Mesh, read_inp, read_msh, write_inp, write_msh};
use proptest::prelude::*;

fn small() -> Mesh {
    let text = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT,TYPE=C3D4,ELSET=E\n1,1,2,3,4\n*NSET,NSET=N\n1,2\n";
    let mut mesh = read_inp(text.as_bytes()).expect("the file is sound").mesh;
    mesh.face_sets.insert("outside".to_owned(), mesh.boundary());
    mesh
}

fn told(text: &str) -> Vec<String> {
    read_inp(text.as_bytes()).expect_err("the file is wrong").iter().map(ToString::to_string).collect()
}

#[test]
fn all_errors_of_an_input_file_come_at_once() {
    let text = "\
*NODE
1, 0, 0, 0
2, 1, zero, 0
3, 0, 1, 0
3, 0, 0, 1
*ELEMENT, TYPE=C3D4
1, 1, 2, 3, 4
*ELEMENT, TYPE=C3D13
2, 1, 2, 3
*ELEMENT
*INCLUDE, INPUT=other.inp
*NSET, NSET=a
b
*NSET, NSET=b
a
";
    assert_eq!(
        told(text),
        [
            "3:7: expected a coordinate, found `zero`",
            "5:1: node 3 is defined twice",
            "7:1: there is no node `4`",
            "8:1: solid elements of type C3D13 are not read; expected 4 or 10 node tetrahedra, 6 or 15 node wedges, 8 or 20 \
             node hexahedra",
            "10:1: `*ELEMENT` needs `TYPE=`",
            "11:1: `*INCLUDE` is not read, and the mesh is not whole without it",
            "13:1: set `b` contains itself",
            "15:1: set `a` contains itself",
        ]
    );
}

#[test]
fn a_file_cut_in_half_says_where_it_ends() {
    let mesh = small();
    let mut text = String::new();
    write_inp(&mesh, &mut text);
    let cut = &text[..text.find("1, 1, 2, 3, 4").expect("the element is there") + 7];
    assert_eq!(told(cut), ["7:8: the file ends too early, within the nodes of an element"]);
    let cut = &text[..text.find("*ELEMENT").expect("the card is there")];
    assert!(told(cut)[0].contains("there is no solid `*ELEMENT`"), "{:?}", told(cut));
    let text = write_msh(&mesh);
    for end in (20..text.len() - 14).step_by(7) {
        let errors = read_msh(&text.as_bytes()[..end]).expect_err("the file is cut");
        assert!(errors.len() == 1 && errors[0].line > 1, "{errors:?}");
    }
}

#[test]
fn files_that_are_something_else_are_refused() {
    let errors = |bytes: &[u8]| read_msh(bytes).expect_err("it is no mesh");
    assert_eq!(errors(b"$MeshFormat\n4.1 1 8\n")[0].fault, FileFault::Binary);
    assert_eq!(errors(b"$MeshFormat\n4.0 0 8\n")[0].fault, FileFault::Version { found: "4.0".to_owned() });
    let error = &errors(b"ISO-10303-21;")[0];
    assert_eq!(error.to_string(), "1:1: expected `$MeshFormat`, found `ISO-10303-21;`");
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 7 2 0 1 1 2 3 4 5\n$EndElements\n";
    let error = &errors(text.as_bytes())[0];
    assert_eq!((error.line, error.column), (6, 3));
    assert!(error.fault.hint().is_some());
}

#[test]
fn errors_are_not_collected_without_end() {
    let text = format!("*NODE\n{}", "x, 1, 2, 3\n".repeat(1000));
    assert_eq!(told(&text).len(), 50);
}

/// Cuts, doubles and replaces pieces of a sound file.
fn damaged(text: &str, at: usize, length: usize, piece: &[u8]) -> Vec<u8> {
    let bytes = text.as_bytes();
    let start = at % bytes.len();
    let end = (start + length).min(bytes.len());
    [&bytes[..start], piece, &bytes[end..]].concat()
}

proptest! {
    #[test]
    fn nothing_panics_on_damaged_files(at in any::<usize>(), length in 0_usize..60, piece in "[-0-9a-z*$,.= \n]{0,12}") {
        let mesh = small();
        let mut text = String::new();
        write_inp(&mesh, &mut text);
        // A mesh that is read is sound enough to be checked.
        if let Ok(imported) = read_inp(&damaged(&text, at, length, piece.as_bytes())) {
            imported.mesh.check();
        }
        if let Ok(imported) = read_msh(&damaged(&write_msh(&mesh), at, length, piece.as_bytes())) {
            imported.mesh.check();
        }
    }

    #[test]
    fn nothing_panics_on_any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = read_inp(&bytes);
        let _ = read_msh(&bytes);
        let _ = read_msh(&[b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n".as_slice(), &bytes].concat());
        let _ = read_inp(&[b"*NODE\n".as_slice(), &bytes].concat());
    }
}
