//! Files that Gmsh wrote, and our own read back.

use std::f64::consts::PI;

use bellcrank_mesh::{
    Imported, Mesh, Note, Shape, Sizes, mesh_stack, read_inp, read_msh, read_msh_entities, write_inp, write_msh,
};

use crate::links::built;

fn data(name: &str) -> Vec<u8> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn msh(name: &str) -> Imported {
    read_msh(&data(name)).unwrap_or_else(|errors| panic!("{name}: {errors:?}"))
}

fn volume_is(mesh: &Mesh, exact: f64, off: f64) {
    assert_eq!(mesh.check(), []);
    let found = mesh.quality().volume;
    assert!((found / exact - 1.0).abs() < off, "{found} instead of {exact}");
}

#[test]
fn meshes_of_gmsh_are_read_in_its_order_of_nodes() {
    let block = 40.0 * 30.0 * 10.0 - PI * 36.0 * 10.0;
    for name in ["tet10-4.1.msh", "tet10-2.2.msh"] {
        let imported = msh(name);
        let mesh = &imported.mesh;
        volume_is(mesh, block, 1e-3);
        assert_eq!((mesh.blocks[0].name.as_str(), mesh.blocks[0].shape), ("steel", Shape::Tet10));
        assert_eq!(mesh.node_sets["corner"].len(), 1);
        assert_eq!(mesh.nodes[mesh.node_sets["corner"][0] as usize], [40.0, 0.0, 0.0]);
        let clamped = &mesh.node_sets["clamped face"];
        assert_eq!(clamped, &mesh.nodes_of_faces(&mesh.face_sets["clamped face"]));
        assert!(clamped.iter().all(|&node| mesh.nodes[node as usize][0].abs() < 1e-9));
        let cylinders = mesh.cylinders();
        assert_eq!(cylinders.len(), 1, "{cylinders:?}");
        assert!(cylinders[0].bore && (cylinders[0].radius - 6.0).abs() < 1e-6, "{cylinders:?}");
        let expected = [12.0, 14.0, 5.0];
        assert!((0..3).all(|i| (cylinders[0].center[i] - expected[i]).abs() < 1e-6), "{cylinders:?}");
    }
    let ring = msh("wedge15.msh").mesh;
    volume_is(&ring, PI * (100.0 - 16.0) * 6.0, 5e-3);
    assert_eq!(ring.blocks[0].shape, Shape::Wedge15);
    let hexahedra = msh("hex20.msh").mesh;
    volume_is(&hexahedra, 3.0 * 2.0 * 1.5, 1e-12);
    assert_eq!((hexahedra.blocks[0].shape, hexahedra.blocks[0].len()), (Shape::Hex20, 12));
    assert_eq!(hexahedra.face_sets["top"].len(), 6);
}

#[test]
fn both_versions_of_one_mesh_are_equal() {
    let (new, old) = (msh("tet10-4.1.msh").mesh, msh("tet10-2.2.msh").mesh);
    assert_eq!(new.node_sets, old.node_sets);
    assert_eq!(new.face_sets, old.face_sets);
    assert_eq!(new.blocks, old.blocks);
}

#[test]
fn the_input_file_of_gmsh_gives_the_same_mesh() {
    let imported = read_inp(&data("tet10.inp")).unwrap_or_else(|errors| panic!("{errors:?}"));
    let msh = msh("tet10-4.1.msh").mesh;
    volume_is(&imported.mesh, msh.quality().volume, 1e-9);
    assert_eq!(imported.mesh.face_sets["bore.A"].len(), msh.face_sets["bore.A"].len());
    assert_eq!(imported.element_sets["steel"].len(), imported.mesh.element_count());
    assert!(imported.notes.iter().any(|note| matches!(note, Note::ElementsLeftOut { name, .. } if name == "CPS6")));
}

#[test]
fn every_surface_of_the_geometry_is_a_face_set_where_asked() {
    let mesh = read_msh_entities(&data("tet10-4.1.msh")).expect("the file is sound").mesh;
    let sets = mesh.face_sets.keys().filter(|name| name.starts_with("face.")).count();
    // Gmsh writes only what is in a group unless told otherwise.
    assert_eq!(sets, 2);
}

fn link_meshes() -> Vec<Mesh> {
    let (_, stack) = (0..).find_map(built).expect("some link can be built");
    let sizes = Sizes { size: Some(0.03), ..Sizes::default() };
    let made = |shape| mesh_stack(&stack, &["A", "B", "C", "D"], shape, &sizes).expect("links can be meshed");
    [Shape::Wedge15, Shape::Tet10, Shape::Wedge6, Shape::Tet4].map(made).to_vec()
}

fn close(a: &Mesh, b: &Mesh) -> bool {
    a.nodes.len() == b.nodes.len()
        && a.nodes.iter().flatten().zip(b.nodes.iter().flatten()).all(|(x, y)| (x - y).abs() < 1e-13)
}

#[test]
fn what_is_written_is_read_back() {
    let mut meshes = link_meshes();
    meshes.push(msh("hex20.msh").mesh);
    for mesh in meshes {
        let mut text = String::new();
        write_inp(&mesh, &mut text);
        assert!(text.lines().all(|line| line.split(", ").all(|entry| entry.len() <= 80)));
        let back = read_inp(text.as_bytes()).unwrap_or_else(|errors| panic!("{errors:?}")).mesh;
        assert!(close(&back, &mesh));
        assert_eq!((&back.blocks, &back.node_sets, &back.face_sets), (&mesh.blocks, &mesh.node_sets, &mesh.face_sets));
        let text = write_msh(&mesh);
        let back = read_msh(text.as_bytes()).unwrap_or_else(|errors| panic!("{errors:?}")).mesh;
        assert_eq!(back.nodes, mesh.nodes);
        assert_eq!((&back.blocks, &back.face_sets), (&mesh.blocks, &mesh.face_sets));
        for (name, nodes) in &mesh.node_sets {
            assert_eq!(&back.node_sets[name], nodes, "{name}");
        }
    }
}

#[test]
fn an_input_file_by_hand_is_understood() {
    let text = "\
*Heading
 by hand
** two tetrahedra, numbered with gaps, of which one has reduced integration in another file
*node, nset = all nodes
 10, 0., 0., 0.
 20, 1., 0, 0
 30, 0, 1.D0, 0
 40, 0, 0, 1
 50, 1, 1, 1
 99, 7, 7, 7
*Element, type=c3d4, elset=Left
 7, 10, 20, 30,
 40
*ELEMENT, TYPE=C3D4, ELSET=Right
 9, 20, 30, 40, 50
*ELEMENT, TYPE=B31
 77, 10, 99
*NSET, NSET=bottom, GENERATE
 10, 30, 10
*NSET, NSET=more
 bottom, 50
*ELSET, ELSET=both
 left, Right
*SURFACE, NAME=foot, TYPE=ELEMENT
 Left, S1
 9, s4
*SURFACE, NAME=skin
 both,
*Solid Section, elset=both, material=steel
*Step
*Step
";
    let imported = read_inp(text.as_bytes()).unwrap_or_else(|errors| panic!("{errors:?}"));
    let mesh = &imported.mesh;
    assert_eq!(imported.node_labels, [10, 20, 30, 40, 50]);
    assert_eq!(mesh.blocks.iter().map(|block| block.name.as_str()).collect::<Vec<_>>(), ["Left", "Right"]);
    assert_eq!(mesh.node_sets["bottom"], [0, 1, 2]);
    assert_eq!(mesh.node_sets["more"], [0, 1, 2, 4]);
    assert_eq!(mesh.node_sets["all nodes"], [0, 1, 2, 3, 4]);
    assert_eq!(imported.element_sets["both"], [(0, 0), (1, 0)]);
    assert_eq!(mesh.face_sets["foot"].len(), 2);
    assert_eq!(mesh.face_sets["skin"], mesh.boundary());
    let told: Vec<String> = imported.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "1 elements of type B31 are no solids and left out, first in line 16",
            "`*SOLID SECTION` in line 29 is not read",
            "2 times `*STEP` are not read, first in line 30",
            "1 nodes belong to no solid element and are left out",
        ]
    );
}
