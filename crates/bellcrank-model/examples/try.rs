use bellcrank_model::*;
fn main() {
    let path = std::env::args().nth(1).expect("path");
    let l = load(std::path::Path::new(&path), &[]);
    print!("{}", l.diagnostics.render(&l.sources, false));
    let Some(m) = l.model else { return };
    print!("{}", m.check().text());
    let r = m.run_all(&[], &mut Silent).expect("run");
    for s in r.studies {
        println!("{} rows {} cols {} {:.2} ms failure {:?} warnings {:?}", s.name, s.table.rows(), s.table.columns.len(), s.seconds*1e3, s.failure, s.warnings);
        for c in &s.table.columns { if let Some(r) = bellcrank_results::Reductions::of(&c.values) { if std::env::args().nth(2).is_some() { println!("   {} [{}] {} .. {}", c.name, c.unit.symbol, c.unit.show(r.min.value), c.unit.show(r.max.value)); } } }
    }
    println!("{:?}", r.warnings);
}
