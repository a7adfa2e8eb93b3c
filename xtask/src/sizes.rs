//! The longest functions and files: printed, never failed on. A long one wants a look, not a number game.

use std::path::Path;

use syn::visit::{self, Visit};

use crate::shell::{Outcome, files, relative, root};

const SHOWN: usize = 10;

/// Prints the ten longest functions and files outside tests, and the medians.
pub(crate) fn run(_: &[String]) -> Outcome {
    let mut all = Sizes::default();
    for path in files(&root(), &|name| name.ends_with(".rs")) {
        if !is_test_file(&path) {
            all.read(&path)?;
        }
    }
    println!("{}", listing("functions", &mut all.functions));
    println!("{}", listing("files", &mut all.files));
    Ok(())
}

fn is_test_file(path: &Path) -> bool {
    let inside = |name: &str| path.components().any(|part| part.as_os_str() == name);
    path.ends_with("tests.rs") || ["tests", "benches", "examples", "fuzz"].into_iter().any(inside)
}

#[derive(Default)]
struct Sizes {
    functions: Vec<(usize, String)>,
    files: Vec<(usize, String)>,
}

impl Sizes {
    fn read(&mut self, path: &Path) -> Outcome {
        let name = relative(path);
        let text = std::fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        self.files.push((text.lines().count(), name.clone()));
        let parsed = syn::parse_file(&text).map_err(|error| format!("{name}: {error}"))?;
        Functions { file: &name, found: &mut self.functions }.visit_file(&parsed);
        Ok(())
    }
}

/// Collects the lines of each function, signature to closing brace.
struct Functions<'a> {
    file: &'a str,
    found: &'a mut Vec<(usize, String)>,
}

impl Functions<'_> {
    fn add(&mut self, signature: &syn::Signature, body: &syn::Block) {
        let (first, last) = (signature.fn_token.span.start().line, body.brace_token.span.close().end().line);
        self.found.push((last + 1 - first, format!("{}:{first} {}", self.file, signature.ident)));
    }
}

impl<'ast> Visit<'ast> for Functions<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.add(&item.sig, &item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.add(&item.sig, &item.block);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !item.attrs.iter().any(is_cfg_test) {
            visit::visit_item_mod(self, item);
        }
    }
}

fn is_cfg_test(attribute: &syn::Attribute) -> bool {
    attribute.path().is_ident("cfg") && attribute.parse_args::<syn::Ident>().is_ok_and(|what| what == "test")
}

fn listing(title: &str, all: &mut [(usize, String)]) -> String {
    all.sort_by(|a, b| b.cmp(a));
    let at = |share: f64| all.get((all.len() as f64 * share) as usize).map_or(0, |(lines, _)| *lines);
    let head = format!("{} {title}: median {} lines, one in ten above {}", all.len(), at(0.5), at(0.1));
    let rows = all.iter().take(SHOWN).map(|(lines, name)| format!("\n  {lines:>4}  {name}"));
    std::iter::once(head).chain(rows).collect()
}
