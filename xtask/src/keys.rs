//! The page of all keys of the model file, made from its JSON Schema: the tables that the reader itself uses.

use std::fmt::Write;

use serde_json::{Map, Value};

const INTRODUCTION: &str = "# Every key of the model file\n\nWritten by `cargo xtask bless` from the tables that the reader uses; a \
    test compares. What the keys mean together is in [model-file.md](model-file.md). A *value* is a number with a unit or an \
    expression in quotes; a *number* has no unit. Keys in bold are required.\n";

/// The whole page.
pub(crate) fn page() -> String {
    let schema = bellcrank_model::schema();
    let mut page = Page { text: INTRODUCTION.to_owned(), done: Vec::new(), alternatives: Vec::new() };
    page.table("The file", &schema);
    if let Some(parameter) = schema.pointer("/$defs/parameters/additionalProperties/anyOf/1") {
        page.table("`[parameters]`: an entry written as a table", parameter);
    }
    if let Some(point) = schema.pointer("/$defs/points/additionalProperties/anyOf/1") {
        page.table("`points`: an entry written as a table", point);
    }
    page.text
}

struct Page {
    text: String,
    /// Headings printed already: some tables occur under several others.
    done: Vec<String>,
    /// Tables of alternatives printed already: some stand behind two keys.
    alternatives: Vec<Value>,
}

impl Page {
    /// A section for a table, and then one for each table in it.
    fn table(&mut self, heading: &str, of: &Value) {
        if self.done.iter().any(|done| done == heading) {
            return;
        }
        self.done.push(heading.to_owned());
        let _ = writeln!(self.text, "\n## {heading}\n\n{}", description(of));
        match of.get("oneOf").and_then(Value::as_array) {
            Some(kinds) => kinds.iter().for_each(|kind| self.kind(kind)),
            None => self.keys(of),
        }
        self.tables_inside(of);
    }

    fn kind(&mut self, of: &Value) {
        let Some(name) = of.pointer("/properties/kind/const").and_then(Value::as_str) else { return };
        let _ = writeln!(self.text, "\n### `kind = \"{name}\"`\n\n{}", description(of));
        self.keys(of);
    }

    fn keys(&mut self, of: &Value) {
        let Some(properties) = properties(of) else { return };
        if properties.keys().all(|name| name == "kind") {
            return;
        }
        self.text.push_str("\n| key | holds | |\n|---|---|---|\n");
        for (name, key) in properties.iter().filter(|(name, _)| *name != "kind") {
            let shown = if is_required(of, name) { format!("**`{name}`**") } else { format!("`{name}`") };
            let _ = writeln!(self.text, "| {shown} | {} | {} |", holds(key), description(key));
        }
    }

    fn tables_inside(&mut self, of: &Value) {
        let kinds = of.get("oneOf").and_then(Value::as_array).into_iter().flatten();
        for (name, key) in std::iter::once(of).chain(kinds).filter_map(properties).flatten() {
            if let Some((heading, table)) = inner_table(name, key) {
                self.table(&heading, table);
            }
            for (heading, table) in alternatives(name, key) {
                if !self.alternatives.contains(table) {
                    self.alternatives.push(table.clone());
                    self.table(&heading, table);
                }
            }
        }
    }
}

/// The table that a key holds: one, a list of them, or named ones.
fn inner_table<'a>(name: &str, key: &'a Value) -> Option<(String, &'a Value)> {
    if properties(key).is_some() {
        return Some((format!("`{name}`"), key));
    }
    let named = key.get("additionalProperties").filter(|table| is_table(table));
    let listed = key.get("items").filter(|table| is_table(table));
    let named = named.map(|table| (format!("`[{name}.NAME]`"), table));
    named.or_else(|| listed.map(|table| (format!("an entry of `{name}`"), table)))
}

/// Tables among what a key may hold, and among what entries of its lists and tables may be.
fn alternatives<'a>(name: &str, key: &'a Value) -> Vec<(String, &'a Value)> {
    let any = |of: &'a Value| of.get("anyOf").and_then(Value::as_array).into_iter().flatten();
    let mut found = Vec::new();
    for one in any(key) {
        found.extend(inner_table(name, one));
        for (inside, heading) in
            [("items", format!("an entry of `{name}`")), ("additionalProperties", format!("`{name}`: an entry"))]
        {
            let tables = one.get(inside).into_iter().flat_map(any).filter(|of| is_table(of));
            found.extend(tables.map(|table| (format!("{heading} written as a table"), table)));
        }
    }
    found
}

fn is_table(of: &Value) -> bool {
    properties(of).is_some() || of.get("oneOf").is_some()
}

fn properties(of: &Value) -> Option<&Map<String, Value>> {
    of.get("properties").and_then(Value::as_object)
}

fn is_required(of: &Value, name: &str) -> bool {
    of.get("required").and_then(Value::as_array).is_some_and(|list| list.iter().any(|key| key == name))
}

fn description(of: &Value) -> &str {
    of.get("description").and_then(Value::as_str).unwrap_or("")
}

/// What may stand behind a key, in words.
fn holds(key: &Value) -> String {
    if let Some(name) = key.get("$ref").and_then(Value::as_str).and_then(|path| path.rsplit('/').next()) {
        return in_words(name).to_owned();
    }
    if let Some(words) = key.get("enum").and_then(Value::as_array) {
        return words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" or ");
    }
    if let Some(all) = key.get("anyOf").and_then(Value::as_array) {
        return all.iter().map(holds).collect::<Vec<_>>().join(" or ");
    }
    key.get("const").map_or_else(|| of_type(key), |word| format!("`{word}`"))
}

fn of_type(key: &Value) -> String {
    match key.get("type").and_then(Value::as_str) {
        Some("array") => list(key),
        Some("object") if key.get("additionalProperties").is_some_and(is_table) => "named tables".to_owned(),
        Some("object") if properties(key).is_none() => named(key),
        Some("object") => "a table".to_owned(),
        Some("integer") => "a whole number".to_owned(),
        Some("boolean") => "`true` or `false`".to_owned(),
        Some(_) => "text".to_owned(),
        None if key.get("type").is_some() => "an expression".to_owned(),
        None if is_table(key) => "a table".to_owned(),
        None => "anything".to_owned(),
    }
}

/// A table of names, and what stands behind each.
fn named(key: &Value) -> String {
    match key.get("additionalProperties").filter(|of| of.is_object()) {
        Some(of) => format!("a table: by name {}", holds(of)),
        None => "a table".to_owned(),
    }
}

fn list(key: &Value) -> String {
    let items = key.get("items").map_or_else(String::new, holds);
    match key.get("minItems").and_then(Value::as_u64) {
        Some(count) => format!("a list of {count}: {items}"),
        None => format!("a list: {items}"),
    }
}

fn in_words(name: &str) -> &str {
    match name {
        "quantity" | "value" => "a value",
        "number" => "a number",
        "values" => "a value or a list of values",
        "vector" => "a list of values, as many as the space has dimensions",
        "axis" => "`\"x\"`, `\"y\"`, `\"z\"` or a vector",
        "points" => "a table of points",
        "parameters" => "a table of parameters",
        "map" => "a table of values",
        "names" => "a list of names",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use crate::shell::root;

    const PAGE: &str = "docs/model-keys.md";

    #[test]
    fn the_page_of_keys_is_what_the_reader_knows() {
        let path = root().join(PAGE);
        let page = super::page();
        if std::env::var_os(crate::bless::SWITCH).is_some() {
            std::fs::write(&path, &page).unwrap_or_else(|error| panic!("{PAGE}: {error}"));
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == page, "{PAGE} is not what the reader knows now: `cargo xtask bless`, and read the diff");
    }
}
