use bellcrank_doc::*;
fn main() {
    let mut sources = Sources::new();
    let mut d = Diagnostics::new();
    for name in std::env::args().skip(1) {
        let bytes = std::fs::read(&name).unwrap();
        let t = std::time::Instant::now();
        let Some(id) = load(&mut sources, &name, &bytes, &mut d) else { continue };
        let tree = parse(&sources, id, &mut d);
        eprintln!("parse {:?} keys {}", t.elapsed(), tree.len());
        if let Some(p) = tree.get("parameters").and_then(|e| e.value.as_table()) {
            let set = ParameterSet::read(p, &mut d);
            eprintln!("params {} {:?}", set.all().len(), t.elapsed());
        }
    }
    d.sort();
    let t = std::time::Instant::now();
    print!("{}", d.render(&sources, false));
    eprintln!("render {:?}, {} diagnostics", t.elapsed(), d.len());
}
