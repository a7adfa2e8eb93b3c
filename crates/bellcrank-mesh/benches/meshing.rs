//! Meshing of a link, with its quality and its boundary; the goal is 30,000 nodes in less than 2 s.

use std::hint::black_box;

use bellcrank_mesh::{Shape, Sizes, mesh_stack};
use bellcrank_solid::{Bar, Eye, Link, Profile, Stack, Web};
use criterion::{Criterion, criterion_group, criterion_main};

/// A bell crank of three eyes, its arms as wide as their eyes, with fillets.
fn bell_crank() -> Stack<f64> {
    let eye =
        |center, bore, outer, half: f64| Eye { center, bore, outer, layers: vec![[-half, half]], clearance: None };
    let arm = |eyes, widths| Web::Bar(Bar { eyes, widths, layers: vec![[-0.01, 0.01]], profile: Profile::Flat });
    let link = Link {
        eyes: vec![
            eye([0.0, 0.0], 0.04, 0.12, 0.025),
            eye([0.28, 0.03], 0.03, 0.08, 0.015),
            eye([-0.06, 0.22], 0.03, 0.08, 0.015),
        ],
        webs: vec![arm([0, 1], [0.08, 0.05]), arm([0, 2], [0.08, 0.05])],
        plates: Vec::new(),
        cuts: Vec::new(),
        fillet: Some(0.015),
    };
    link.build().expect("the bell crank is sound")
}

fn meshing(c: &mut Criterion) {
    let stack = bell_crank();
    let mut group = c.benchmark_group("mesh");
    group.sample_size(10);
    for (shape, size) in [(Shape::Wedge15, 0.0065), (Shape::Tet10, 0.0085)] {
        let sizes = Sizes { size: Some(size), ..Sizes::default() };
        let mesh = mesh_stack(&stack, &["A", "B", "C"], shape, &sizes).expect("the bell crank can be meshed");
        let name = format!("bell crank, {}, {} nodes", shape.abaqus(), mesh.nodes.len());
        group.bench_function(name, |b| b.iter(|| mesh_stack(black_box(&stack), &["A", "B", "C"], shape, &sizes)));
        group.bench_function(format!("quality, {}", shape.abaqus()), |b| b.iter(|| black_box(&mesh).quality()));
        group.bench_function(format!("boundary, {}", shape.abaqus()), |b| b.iter(|| black_box(&mesh).boundary()));
    }
    group.finish();
}

criterion_group!(benches, meshing);
criterion_main!(benches);
