//! The tables of fields as JSON Schemas, so that editors complete and check scenes and project files as they
//! are typed.

use serde_json::{Map, Value, json};

use crate::collision::{Bodies, QUERIES, Question};
use crate::geometry::shape::{FieldType, KINDS};

use super::body::{ANGLES, MATRIX, SPINS};
use super::fields::{
    CANVAS, EXERCISE, EXPECTED, EXPECTED_POINTS, Field, LABEL, LIVE, PANEL, QUERY, ROOT, STEP, TableRows,
    shape_rows,
};
use super::holds::Holds;
use super::project_fields::{HANDOUT, PROJECT, RENDER};
use super::{COMPASS, Grip, When};

/// The tag of a language: letters, then parts of letters and digits.
const LANGUAGE: &str = "^[A-Za-z]{2,3}(-[A-Za-z0-9]{1,8})*$";

/// Between which sizes the larger of two numbers lies whose squares add up to 1, as far as a rotation may be
/// off, and a little more.
const UNIT: [f64; 2] = [0.706, 1.001];

/// Pairs of keys of a shape that say the same.
const SAME: [[&str; 2]; 4] = [ANGLES, [ANGLES[0], MATRIX], [ANGLES[1], MATRIX], SPINS];

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
    if field.name == "lang" {
        value["pattern"] = json!(LANGUAGE);
    }
    if field.name == MATRIX {
        let [least, most] = UNIT;
        value["items"] = json!({ "type": "number", "minimum": -most, "maximum": most });
        value["contains"] = json!({ "anyOf": [{ "minimum": least }, { "maximum": -least }] });
    }
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
        Holds::RectangleOr(word) => json!({ "anyOf": [numbers(4), { "const": word }] }),
        Holds::Points => json!({ "type": "array", "items": numbers(2) }),
        Holds::Names => {
            json!({
                "type": "array", "items": { "type": "string" },
                "minItems": 1, "maxItems": 2, "uniqueItems": true,
            })
        }
        Holds::Drags => drags(),
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
        Holds::Tables("shapes") => {
            json!({ "type": "object", "additionalProperties": one_of("kind", &shapes()) })
        }
        Holds::Tables(_) => {
            let label = json!({ "anyOf": [{ "type": "string" }, of(&LABEL)] });
            json!({ "type": "object", "additionalProperties": label })
        }
        Holds::List("steps") => json!({ "type": "array", "items": step() }),
        Holds::List("handouts") => json!({ "type": "array", "items": of(&HANDOUT) }),
        Holds::List("panels") => json!({ "type": "array", "items": of(&PANEL) }),
        Holds::List(_) => json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 }),
        Holds::Table if field.name == "query" => query(),
        Holds::Table => of(match field.name {
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

/// The schema of what a reader may drag: a shape, or with a dot what it has.
fn drags() -> Value {
    let grips = Grip::words().collect::<Vec<_>>().join("|");
    // A word after the last dot is a grip; a name may have dots before other signs.
    let pattern = format!(r"^[^.]*$|\.({grips})$|\.[^.]*[^a-z.][^.]*$|\.$");
    json!({ "type": "array", "items": { "type": "string", "pattern": pattern } })
}

/// The schemas of all kinds of shape, each with its word.
fn shapes() -> Vec<(&'static str, Value)> {
    KINDS
        .iter()
        .map(|kind| {
            let mut shape = Value::Object(table(&shape_rows(kind)));
            shape["properties"]["kind"] = json!({ "const": kind.name, "description": kind.about });
            for field in kind.fields {
                let holds = &mut shape["properties"][field.name];
                match field.holds {
                    FieldType::Length => holds["minimum"] = json!(0),
                    FieldType::Extents => holds["items"]["exclusiveMinimum"] = json!(0),
                    FieldType::Points { min } => holds["minItems"] = json!(min),
                    FieldType::Count { .. } | FieldType::Point | FieldType::Switch => {}
                }
            }
            let known = |both: &[&str; 2]| both.iter().all(|key| shape["properties"].get(key).is_some());
            let same = SAME.iter().filter(|both| known(both));
            shape["allOf"] = same.map(|both| json!({ "not": { "required": both } })).collect();
            (kind.name, shape)
        })
        .collect()
}

/// The schema of what is said of some steps: of those that are skipped there are no words.
fn step() -> Value {
    let mut schema = of(&STEP);
    let words = json!({ "not": { "anyOf": [{ "required": ["title"] }, { "required": ["text"] }] } });
    schema["if"] = json!({ "required": ["skip"], "properties": { "skip": { "const": true } } });
    schema["then"] = words;
    schema
}

/// The schema of a query: how many bodies it is of depends on its kind.
fn query() -> Value {
    let mut schema = of(&QUERY);
    let bodies = |query: &Question| {
        let least = if query.bodies == Bodies::Two { 2 } else { 1 };
        case("kind", query.word, &json!({ "properties": { "of": { "minItems": least } } }))
    };
    schema["allOf"] = QUERIES.iter().map(bodies).collect();
    schema
}

/// The schema of a table that one of its keys tells apart, so that what is wrong with it is said of its own
/// kind alone.
///
/// ```
/// let circle = serde_json::json!({ "type": "object", "required": ["kind", "radius"] });
/// let schema = tracefig::scene::one_of("kind", &[("circle", circle)]);
/// assert_eq!(schema["properties"]["kind"]["enum"][0], "circle");
/// ```
#[must_use]
pub fn one_of(key: &str, tables: &[(&str, Value)]) -> Value {
    let words: Vec<_> = tables.iter().map(|(word, _)| *word).collect();
    let cases: Vec<_> = tables.iter().map(|(word, table)| case(key, word, table)).collect();
    json!({ "type": "object", "required": [key], "properties": { key: { "enum": words } }, "allOf": cases })
}

/// The schema of tables of which one key has a certain value.
fn case(key: &str, word: &str, then: &Value) -> Value {
    json!({ "if": { "required": [key], "properties": { key: { "const": word } } }, "then": then })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_is_about_one_long_and_what_is_dragged_is_a_grip() {
        let scene = schema();
        let drag = &scene["properties"]["live"]["properties"]["drag"]["items"]["pattern"];
        let words = drag.as_str().unwrap();
        assert!(Grip::words().all(|word| words.contains(word)), "{words}");
        let shape = &scene["properties"]["shapes"]["additionalProperties"]["allOf"];
        let boxed =
            shape.as_array().unwrap().iter().find(|case| case["if"]["properties"]["kind"]["const"] == "box");
        let rotation = &boxed.unwrap()["then"]["properties"]["rotation"];
        assert_eq!(rotation["items"]["maximum"], 1.001);
        // The larger of cos and sin is at least the root of a half.
        assert!(
            rotation["contains"]["anyOf"][0]["minimum"].as_f64().unwrap() < std::f64::consts::FRAC_1_SQRT_2
        );
    }

    #[test]
    fn every_key_of_every_table_is_in_the_schema() {
        let text = schema().to_string();
        for field in super::super::fields::TABLES.iter().flat_map(|t| t.fields) {
            assert!(text.contains(&format!("\"{}\":", field.name)), "{}", field.name);
        }
        let of_project = project_schema().to_string();
        for field in super::super::project_fields::PROJECT_TABLES.iter().flat_map(|t| t.fields) {
            assert!(of_project.contains(&format!("\"{}\":", field.name)), "{}", field.name);
        }
        for kind in KINDS {
            assert!(text.contains(&format!("\"const\":\"{}\"", kind.name)), "{}", kind.name);
        }
    }
}
