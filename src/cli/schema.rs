//! JSON Schemas: of scenes, with the layers and their options; of project files, with the formats; of theme
//! files.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};
use tracefig::drawing::Role;
use tracefig::figure::exercise::askables;
use tracefig::figure::layer::{LAYERS, Layer};
use tracefig::figure::theme::{THEMES, ThemeKey, ThemeValue, keys};
use tracefig::figure::{COMMON, OptionSpec, Takes, values};
use tracefig::output::{FORMATS, PAPERS};
use tracefig::scene;

/// How a colour of a theme file is written.
const THEME_COLOR: &str = "^#([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})$";

/// Where the schema says what stands in a panel's list of layers.
const LAYERS_OF_A_PANEL: &str = "/properties/panels/items/properties/layers/items";

/// Where the schema of a project file says what stands in its list of formats.
const FORMATS_OF_A_PROJECT: &str = "/properties/render/properties/formats/items";

/// Where the schema of a project file says which paper a handout has.
const PAPER_OF_A_HANDOUT: &str = "/properties/handout/items/properties/paper";

/// How a theme file is named, or its dark side.
const THEME_FILE: &str = r"\.toml(#dark)?$";

/// How a text ends that is drawn: each formula in it has its end.
const DRAWN: &str = "$";

/// How a text ends that is read and not drawn: a formula without an end stands as it is.
const READ: &str = r"(?:\$(?:[^$\\]|\\[\s\S])*)?$";

/// Where the schema says what texts with formulas, roles and values are, and how they end.
const TEXTS: [(&str, &str); 8] = [
    ("/properties/title", READ),
    ("/properties/alt", READ),
    ("/properties/headline", DRAWN),
    ("/properties/caption", DRAWN),
    ("/properties/panels/items/properties/title", DRAWN),
    ("/properties/panels/items/properties/caption", DRAWN),
    ("/properties/labels/additionalProperties/anyOf/0", DRAWN),
    ("/properties/labels/additionalProperties/anyOf/1/properties/text", DRAWN),
];

/// Where the schema says what an exercise asks for.
const ASKED: &str = "/properties/exercise/properties/ask";

/// Where the schema says which layers and labels a question hides.
const HIDDEN: &str = "/properties/exercise/properties/hide";

/// A file that a schema is of.
pub(crate) struct Schema {
    /// The word that asks for it.
    pub(crate) name: &'static str,
    /// Makes it.
    pub(crate) make: fn() -> Value,
}

/// Every schema.
pub(crate) static SCHEMAS: [Schema; 3] = [
    Schema { name: "schema", make: scene_schema },
    Schema { name: "project-schema", make: project_schema },
    Schema { name: "theme-schema", make: theme_schema },
];

/// JSON Schema (draft 2020-12) of a scene.
fn scene_schema() -> Value {
    let mut schema = scene::schema();
    for (place, end) in TEXTS {
        if let Some(text) = schema.pointer_mut(place) {
            text["pattern"] = json!(markup(end));
        }
    }
    let asked: Vec<_> = askables().map(|(name, _)| name).collect();
    if let Some(ask) = schema.pointer_mut(ASKED) {
        *ask = one_or_more(&json!({ "enum": asked }), &ask["description"]);
    }
    let layers = LAYERS.iter().map(|layer| layer.name);
    let keys = LAYERS.iter().flat_map(|layer| layer.labels).map(|label| label.key);
    let hidden: BTreeSet<_> = layers.chain(keys).collect();
    if let Some(hide) = schema.pointer_mut(HIDDEN) {
        *hide = one_or_more(&json!({ "enum": hidden }), &hide["description"]);
    }
    themed(&mut schema, "/properties/canvas/properties/theme");
    if let Some(layers) = schema.pointer_mut(LAYERS_OF_A_PANEL) {
        let names: Vec<_> = LAYERS.iter().map(|layer| layer.name).collect();
        let tables: Vec<_> = LAYERS.iter().map(|layer| (layer.name, table(layer))).collect();
        // A layer without options is its name.
        *layers = json!({
            "type": ["string", "object"],
            "if": { "type": "string" }, "then": { "enum": names }, "else": scene::one_of("layer", &tables),
        });
    }
    schema
}

/// What a text with formulas, roles and values is, up to its end: each role and value that is named is one of
/// ours. What stands within a formula is left open.
fn markup(end: &str) -> String {
    let roles = Role::OF_WORDS.map(Role::name).join("|");
    let values: Vec<_> = values().map(|(name, _)| name.replace('.', r"\.")).collect();
    let values = values.join("|");
    let (escaped, formula) = (r"\\[\s\S]", r"\$(?:[^$\\]|\\[\s\S])*\$");
    let digits = r"(?::\.(?:[0-9]+|0*[1-9][0-9]*g))?";
    let named = format!(r"\{{(?:{roles})\||\{{=(?:{values}){digits}\}}|\{{(?![a-z][a-z-]*\||=)");
    format!(r"^(?:[^$\\{{]|{escaped}|{formula}|{named})*{end}")
}

/// Says which themes there are, where the schema has one: a word for one of the house, or a file.
fn themed(schema: &mut Value, place: &str) {
    if let Some(theme) = schema.pointer_mut(place) {
        let names: Vec<_> = THEMES.iter().map(|theme| theme.name).collect();
        let file = json!({ "type": "string", "pattern": THEME_FILE });
        let about = theme["description"].take();
        *theme = json!({ "anyOf": [{ "enum": names }, file] });
        if about.is_string() {
            theme["description"] = about;
        }
    }
}

/// The schema of one value or a list of them.
fn one_or_more(one: &Value, about: &Value) -> Value {
    json!({ "anyOf": [one, { "type": "array", "items": one }], "description": about })
}

/// JSON Schema (draft 2020-12) of a project file.
fn project_schema() -> Value {
    let mut schema = scene::project_schema();
    themed(&mut schema, "/properties/canvas/properties/theme");
    themed(&mut schema, "/properties/render/properties/themes/items");
    themed(&mut schema, "/properties/handout/items/properties/theme");
    if let Some(formats) = schema.pointer_mut(FORMATS_OF_A_PROJECT) {
        *formats = json!({ "enum": FORMATS.iter().map(|format| format.name).collect::<Vec<_>>() });
    }
    if let Some(paper) = schema.pointer_mut(PAPER_OF_A_HANDOUT) {
        *paper = json!({ "enum": PAPERS.map(|paper| paper.name), "description": paper["description"] });
    }
    schema
}

/// JSON Schema (draft 2020-12) of a theme file.
fn theme_schema() -> Value {
    let object = || json!({ "type": "object", "properties": {}, "additionalProperties": false });
    let mut schema = object();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("tracefig theme file");
    for ThemeKey { table, name, takes, about } in keys() {
        let mut value = match takes {
            ThemeValue::Base => json!({ "enum": THEMES.iter().map(|theme| theme.name).collect::<Vec<_>>() }),
            ThemeValue::Color => json!({ "type": "string", "pattern": THEME_COLOR }),
            ThemeValue::Share => json!({ "type": "number", "minimum": 0, "maximum": 1 }),
            ThemeValue::Pixels(least, most) => {
                json!({ "type": "number", "minimum": least, "maximum": most })
            }
        };
        value["description"] = json!(about);
        if table.is_empty() {
            schema["properties"][name] = value;
            continue;
        }
        let within = &mut schema["properties"][table];
        if within.is_null() {
            *within = object();
        }
        within["properties"][name] = value;
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
