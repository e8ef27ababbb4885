//! The JSON Schema of scenes: the tables of fields, and in them the layers with their options.

use serde_json::{Map, Value, json};
use tracefig::drawing::Role;
use tracefig::figure::layer::{LAYERS, Layer};
use tracefig::figure::{COMMON, OptionSpec, Takes};
use tracefig::scene;

/// Where the schema says what stands in a panel's list of layers.
const LAYERS_OF_A_PANEL: &str = "/properties/panels/items/properties/layers/items";

/// JSON Schema (draft 2020-12) of a scene.
pub(crate) fn schema() -> Value {
    let mut schema = scene::schema();
    if let Some(layers) = schema.pointer_mut(LAYERS_OF_A_PANEL) {
        let names: Vec<_> = LAYERS.iter().map(|layer| layer.name).collect();
        let tables: Vec<_> = LAYERS.iter().map(table).collect();
        *layers = json!({ "anyOf": [{ "enum": names }, { "oneOf": tables }] });
    }
    schema
}

/// The schema of a layer with its options.
fn table(layer: &Layer) -> Value {
    let mut properties = Map::new();
    properties.insert("layer".to_owned(), json!({ "const": layer.name, "description": layer.about }));
    properties
        .extend(layer.options.iter().chain(COMMON).map(|option| (option.name.to_owned(), holds(option))));
    json!({
        "type": "object", "properties": properties, "required": ["layer"], "additionalProperties": false,
    })
}

/// The schema of what an option takes.
fn holds(option: &OptionSpec) -> Value {
    let one_or_more = |one: Value| json!({ "anyOf": [one, { "type": "array", "items": one }] });
    let mut schema = match option.takes {
        Takes::Flag => json!({ "type": "boolean" }),
        Takes::Number => json!({ "type": "number" }),
        Takes::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Takes::Point => {
            json!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 })
        }
        Takes::Counts => one_or_more(json!({ "type": "integer", "minimum": 0 })),
        Takes::Word(words) => json!({ "enum": words }),
        Takes::Words(words) => one_or_more(json!({ "enum": words })),
        Takes::Bodies | Takes::Lines => one_or_more(json!({ "type": "string" })),
        Takes::When(words) => {
            json!({ "anyOf": [{ "type": "number", "minimum": 0, "maximum": 1 }, { "enum": words }] })
        }
        Takes::Role => json!({ "enum": Role::ALL.map(Role::name) }),
    };
    schema["description"] = json!(format!("{}; default: {}", option.about, option.default));
    schema
}
