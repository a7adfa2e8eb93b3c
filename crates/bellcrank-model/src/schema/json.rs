//! The format as a JSON Schema.

use bellcrank_doc::Dimension;
use serde_json::{Map, Value, json};

use super::keys::{AXES, DIRECTIONS, Key, Kind, Schema, Shape, Short};
use super::studies::OPEN;
use super::tables::{MODEL, PLACE};

/// JSON Schema (draft 2020-12) of the model file, from the tables that the reader uses.
#[must_use]
pub fn schema() -> Value {
    let mut root = Map::new();
    root.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    root.insert("title".to_owned(), json!("bellcrank model file"));
    root.insert("$defs".to_owned(), definitions());
    if let Value::Object(model) = object(&MODEL) {
        root.extend(model);
    }
    Value::Object(root)
}

/// Shapes that occur often, by name.
fn definitions() -> Value {
    let vector = |item: Value| json!({ "type": "array", "items": item, "minItems": 2, "maxItems": 3 });
    let dimensional = json!({ "anyOf": [
        { "type": "string", "description": "a number with a unit, or an expression" },
        { "const": 0 }
    ] });
    let number = json!({ "type": ["number", "string"] });
    let reference = json!({ "$ref": "#/$defs/quantity" });
    json!({
        "quantity": dimensional,
        "number": number,
        "value": number,
        "values": { "anyOf": [{ "$ref": "#/$defs/number" }, { "type": "array", "items": { "$ref": "#/$defs/number" } }] },
        "vector": vector(reference),
        "axis": { "anyOf": [{ "enum": AXES }, vector(json!({ "$ref": "#/$defs/number" }))] },
        "points": { "type": "object", "additionalProperties": { "anyOf": [{ "$ref": "#/$defs/vector" }, object(&PLACE)] } },
        "parameters": { "type": "object", "additionalProperties": { "anyOf": [{ "$ref": "#/$defs/number" }, parameter()] } },
        "map": { "type": "object", "additionalProperties": { "$ref": "#/$defs/number" } },
        "names": { "type": "array", "items": { "type": "string" } },
    })
}

/// A parameter written as a table; the keys are those of `bellcrank-doc`.
fn parameter() -> Value {
    let number = json!({ "$ref": "#/$defs/number" });
    json!({
        "type": "object",
        "properties": {
            "value": number, "min": number, "max": number, "tolerance": number, "sigma": number,
            "distribution": { "enum": ["uniform", "normal", "truncated"] }, "note": { "type": "string" },
        },
        "required": ["value"],
        "additionalProperties": false,
    })
}

fn object(schema: &'static Schema) -> Value {
    if schema.kinds.is_empty() {
        return table(schema.doc, schema.keys.iter(), None, !schema.keys.is_empty());
    }
    // A study takes its kind from the one it is `like`; then any kind's keys may stand in it.
    let like = schema.keys.iter().any(|key| key.name == "like");
    let mut variants: Vec<Value> = schema.kinds.iter().map(|kind| variant(schema, kind)).collect();
    if like {
        variants.push(json!({ "type": "object", "required": ["like"], "not": { "required": ["kind"] } }));
    }
    json!({ "description": schema.doc, "oneOf": variants })
}

fn variant(schema: &'static Schema, kind: &'static Kind) -> Value {
    let keys = schema.keys.iter().chain(kind.keys);
    let mut found = table(kind.doc, keys, Some(kind.name), !OPEN.contains(&kind.name));
    if schema.usual == Some(kind.name)
        && let Some(required) = found.get_mut("required").and_then(Value::as_array_mut)
    {
        required.retain(|key| key != "kind");
    }
    found
}

fn table(doc: &str, keys: impl Iterator<Item = &'static Key>, kind: Option<&str>, closed: bool) -> Value {
    let mut properties = Map::new();
    let mut required = Vec::new();
    if let Some(kind) = kind {
        properties.insert("kind".to_owned(), json!({ "const": kind }));
        required.push("kind");
    }
    for key in keys {
        properties.insert(key.name.to_owned(), documented(shape(key.shape), key.doc));
        required.extend(key.required.then_some(key.name));
    }
    json!({
        "description": doc,
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": !closed,
    })
}

fn documented(mut shape: Value, doc: &str) -> Value {
    if let Value::Object(map) = &mut shape {
        map.entry("description").or_insert_with(|| json!(doc));
    }
    shape
}

fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/$defs/{name}") })
}

fn quantity(dimension: Dimension) -> Value {
    reference(if dimension.is_none() { "number" } else { "quantity" })
}

fn shape(of: Shape) -> Value {
    match of {
        Shape::Version => json!({ "const": 1 }),
        Shape::Text | Shape::Name => json!({ "type": "string" }),
        Shape::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Shape::Names => reference("names"),
        Shape::Boolean => json!({ "type": "boolean" }),
        Shape::Whole(from, to) => json!({ "type": "integer", "minimum": from, "maximum": to }),
        Shape::OneOf(words) => json!({ "enum": words }),
        Shape::Value(dimension) | Shape::Signal(dimension) => quantity(dimension),
        Shape::Along(_) => reference("quantity"),
        Shape::Vector(_) | Shape::SignalVector(_) => reference("vector"),
        Shape::List(dimension, lengths) => list(dimension, lengths),
        Shape::Values => reference("values"),
        Shape::Axis => reference("axis"),
        Shape::Response => response(),
        Shape::Free => reference("value"),
        Shape::Start => reference("quantity"),
        Shape::Responses => json!({ "anyOf": [
            { "type": "array", "items": response() },
            { "type": "object", "additionalProperties": response() },
        ] }),
        Shape::Objective(schema) => {
            let part = json!({ "anyOf": [response(), object(schema)] });
            json!({ "anyOf": [response(), { "type": "array", "items": part }] })
        }
        Shape::Comparisons => json!({ "anyOf": [
            { "type": "string" },
            { "type": "array", "items": { "type": "string" } },
        ] }),
        Shape::ByParameter(schema, short) => {
            json!({ "anyOf": [reference("names"), { "type": "object", "additionalProperties": said(schema, short) }] })
        }
        Shape::Between(schema) => {
            let pair = json!({ "type": "array", "items": reference("value"), "minItems": 2, "maxItems": 2 });
            json!({ "anyOf": [pair, object(schema)] })
        }
        Shape::Directions => json!({ "type": "object", "additionalProperties": { "enum": DIRECTIONS } }),
        Shape::Table(schema) => object(schema),
        Shape::Switch(schema) => json!({ "anyOf": [{ "type": "boolean" }, object(schema)] }),
        Shape::Tables(schema) => json!({ "type": "array", "items": object(schema) }),
        Shape::Named(schema) => json!({ "type": "object", "additionalProperties": object(schema) }),
        Shape::Points => reference("points"),
        Shape::Parameters => reference("parameters"),
        Shape::Map => reference("map"),
        Shape::NamesOrMap => json!({ "anyOf": [reference("names"), { "type": "object" }] }),
        Shape::Row => {
            json!({ "anyOf": [{ "enum": ["worst", "all"] }, { "type": "integer", "minimum": 0 }, { "type": "object" }] })
        }
        Shape::Spot => spot(),
        Shape::Pairs(dimension) => json!({ "type": "array", "items": list(dimension, &[2]) }),
        Shape::Outline(corner) => {
            json!({ "type": "array", "items": { "anyOf": [{ "type": "string" }, reference("vector"), object(corner)] } })
        }
    }
}

/// A point by name, or coordinates.
fn spot() -> Value {
    json!({ "anyOf": [{ "type": "string" }, reference("vector")] })
}

fn response() -> Value {
    json!({ "type": ["string", "number"] })
}

/// What may be said of a parameter: a table, or something short in its place.
fn said(schema: &'static Schema, short: Short) -> Value {
    let values = json!({ "type": "array", "items": reference("value") });
    match short {
        Short::Nothing => object(schema),
        Short::Value => json!({ "anyOf": [reference("value"), object(schema)] }),
        Short::Levels => json!({ "anyOf": [{ "type": "integer", "minimum": 2 }, values, object(schema)] }),
    }
}

/// A list of one of some lengths; a single value where 1 is among them.
fn list(dimension: Dimension, lengths: &[usize]) -> Value {
    let one = |&length: &usize| match length {
        1 => quantity(dimension),
        n => json!({ "type": "array", "items": quantity(dimension), "minItems": n, "maxItems": n }),
    };
    json!({ "anyOf": lengths.iter().map(one).collect::<Vec<_>>() })
}
