//! The tables of fields as JSON Schemas, so that editors complete and check scenes and project files as they
//! are typed.

use serde_json::{Map, Value, json};

use crate::geometry::shape::KINDS;

use super::fields::{
    CANVAS, EXERCISE, EXPECTED, EXPECTED_POINTS, Field, LABEL, LIVE, PANEL, PROJECT, QUERY, RENDER, ROOT,
    STEP, TableRows, shape_rows,
};
use super::holds::Holds;
use super::{COMPASS, When};

/// JSON Schema (draft 2020-12) of a scene. Which layers there are is left open.
///
/// ```
/// let schema = tracefig::scene::schema();
/// assert_eq!(schema["required"], serde_json::json!(["shapes", "query"]));
/// assert_eq!(schema["properties"]["canvas"]["properties"]["width"]["type"], "number");
/// ```
#[must_use]
pub fn schema() -> Value {
    titled("tracefig scene", table(ROOT.fields))
}

/// JSON Schema (draft 2020-12) of a project file. Which formats there are is left open.
///
/// ```
/// let schema = tracefig::scene::project_schema();
/// assert_eq!(schema["properties"]["render"]["properties"]["scenes"]["minItems"], 1);
/// ```
#[must_use]
pub fn project_schema() -> Value {
    titled("tracefig project file", table(PROJECT.fields))
}

/// A whole schema from the schema of its table.
fn titled(title: &str, mut schema: Map<String, Value>) -> Value {
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(title));
    Value::Object(schema)
}

/// The schema of a table with these keys.
fn table(fields: &[Field]) -> Map<String, Value> {
    let properties: Map<String, Value> =
        fields.iter().map(|field| (field.name.to_owned(), described(field))).collect();
    let required: Vec<_> = fields.iter().filter(|f| f.required).map(|f| f.name).collect();
    let mut object = Map::new();
    object.insert("type".to_owned(), json!("object"));
    object.insert("properties".to_owned(), Value::Object(properties));
    object.insert("required".to_owned(), json!(required));
    object.insert("additionalProperties".to_owned(), json!(false));
    object
}

fn of(rows: &TableRows) -> Value {
    Value::Object(table(rows.fields))
}

/// The schema of what a key holds, with its line of help.
fn described(field: &Field) -> Value {
    let mut value = holds(field);
    if let Value::Object(object) = &mut value {
        object.insert("description".to_owned(), json!(field.about));
    }
    value
}

/// The schema of a list of so many numbers.
fn numbers(count: usize) -> Value {
    json!({ "type": "array", "items": { "type": "number" }, "minItems": count, "maxItems": count })
}

fn holds(field: &Field) -> Value {
    match field.holds {
        Holds::Text => json!({ "type": "string" }),
        Holds::Word { known, .. } => json!({ "enum": known() }),
        Holds::Number { min, max } => json!({ "type": "number", "minimum": min, "maximum": max }),
        Holds::NumberOr { min, max, word } => {
            json!({ "anyOf": [{ "type": "number", "minimum": min, "maximum": max }, { "const": word }] })
        }
        Holds::ColorOr(word) => {
            json!({ "anyOf": [{ "type": "string", "pattern": "^#[0-9A-Fa-f]{6}$" }, { "const": word }] })
        }
        Holds::Count { min, max } => json!({ "type": "integer", "minimum": min, "maximum": max }),
        Holds::Switch => json!({ "type": "boolean" }),
        Holds::Pair => numbers(2),
        Holds::Rectangle => numbers(4),
        Holds::Points => json!({ "type": "array", "items": numbers(2) }),
        Holds::Names => {
            json!({ "type": "array", "items": { "type": "string" }, "minItems": 1, "maxItems": 2 })
        }
        Holds::Drags => json!({ "type": "array", "items": { "type": "string" } }),
        Holds::Texts(_) => json!({ "anyOf": [
            { "type": "string" },
            { "type": "array", "items": { "type": "string" } },
        ] }),
        Holds::Moment => json!({ "anyOf": [
            { "type": "number", "minimum": 0, "maximum": 1 },
            { "enum": When::WORDS.map(|(word, _)| word) },
        ] }),
        Holds::LabelPlace => {
            json!({ "anyOf": [{ "enum": COMPASS }, numbers(2)] })
        }
        Holds::Layers => json!({ "type": "array", "items": { "anyOf": [
            { "type": "string" },
            { "type": "object", "properties": { "layer": { "type": "string" } }, "required": ["layer"] },
        ] } }),
        Holds::Tables("shapes") => json!({ "type": "object", "additionalProperties": { "oneOf": shapes() } }),
        Holds::Tables(_) => {
            let label = json!({ "anyOf": [{ "type": "string" }, of(&LABEL)] });
            json!({ "type": "object", "additionalProperties": label })
        }
        Holds::List("steps") => json!({ "type": "array", "items": of(&STEP) }),
        Holds::List("panels") => json!({ "type": "array", "items": of(&PANEL) }),
        Holds::List(_) => json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 }),
        Holds::Table => of(match field.name {
            "query" => &QUERY,
            "exercise" => &EXERCISE,
            "expected" => &EXPECTED,
            "points" => &EXPECTED_POINTS,
            "live" => &LIVE,
            "render" => &RENDER,
            _ => &CANVAS,
        }),
        Holds::Anything => json!({}),
    }
}

/// The schemas of all kinds of shape, told apart by `kind`.
fn shapes() -> Vec<Value> {
    KINDS
        .iter()
        .map(|kind| {
            let mut shape = Value::Object(table(&shape_rows(kind)));
            shape["properties"]["kind"] = json!({ "const": kind.name, "description": kind.about });
            shape
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_every_table_is_in_the_schema() {
        let text = schema().to_string();
        for field in super::super::fields::TABLES.iter().flat_map(|t| t.fields) {
            assert!(text.contains(&format!("\"{}\":", field.name)), "{}", field.name);
        }
        let of_project = project_schema().to_string();
        for field in super::super::fields::PROJECT_TABLES.iter().flat_map(|t| t.fields) {
            assert!(of_project.contains(&format!("\"{}\":", field.name)), "{}", field.name);
        }
        for kind in KINDS {
            assert!(text.contains(&format!("\"const\":\"{}\"", kind.name)), "{}", kind.name);
        }
    }
}
