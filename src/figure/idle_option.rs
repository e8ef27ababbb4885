//! Options that change nothing of what their layer draws, as `centers` of a ghost that has no centre of its
//! own: found by drawing the panel without them.

use std::ops::Range;

use crate::geometry::sort_by;
use crate::scene::{LayerSpec, Scene, Variant};

use super::fault::{Fault, Problem};
use super::layer::{OptionSpec, Options, Takes};
use super::panel::{LayerPlan, PanelPlan};
use super::runs::Runs;
use super::sketch::{Request, Sketched};
use super::theme::Theme;

/// A note for each flag of a scene's layers that is not what holds without it, and makes no difference;
/// `told` are the notes so far, which say of some options why.
pub(super) fn idle(
    (scene, runs, theme): (&Scene, &Runs, &Theme),
    panels: &[PanelPlan],
    sketched: &[Sketched],
    told: &[Problem],
) -> Vec<Problem> {
    // A question has not the layers of its answer; a panel with an inset draws twice.
    if scene.variant == Variant::Question {
        return Vec::new();
    }
    let specs = || scene.panels.iter().flat_map(|panel| panel.layers.iter().flatten());
    let flags_of = |planned: &LayerPlan| -> Option<Flags<'_>> {
        let spec = specs().find(|spec| spec.name.span == planned.span)?;
        let is_told = |span: &Range<usize>| told.iter().any(|p| p.span == *span);
        let told_of = |name| spec.options.iter().any(|(key, _)| key.value == name && is_told(&key.span));
        let flags = planned.layer.options.iter().filter(|option| is_unusual(option, &planned.options));
        let names = flags.map(|option| option.name).filter(|name| !told_of(*name));
        (!is_told(&planned.span)).then(|| Flags { spec, names: names.collect() })
    };
    let of_panel = |(panel, own): (&PanelPlan, &Sketched)| -> Vec<Problem> {
        let layers = panel.layers.iter().filter(|_| panel.source.inset.is_none());
        let flags: Vec<_> = layers.map(flags_of).collect();
        let idle = |nth| {
            let other = panel.sketch_with(&without(panel, &flags, nth), (scene, runs, theme));
            let of_layer = |(index, (planned, flags)): (usize, (&LayerPlan, &Option<Flags>))| {
                let Flags { spec, names } = flags.as_ref()?;
                let option = names.get(nth).filter(|_| !differ(own, &other, index))?;
                note(spec, planned.layer.name, option)
            };
            panel.layers.iter().zip(&flags).enumerate().filter_map(of_layer).collect::<Vec<_>>()
        };
        let most = flags.iter().flatten().map(|flags| flags.names.len()).max().unwrap_or(0);
        let mut notes: Vec<Problem> = (0..most).flat_map(idle).collect();
        sort_by(&mut notes, |p, q| p.span.start.cmp(&q.span.start));
        notes
    };
    panels.iter().zip(sketched).flat_map(of_panel).collect()
}

/// A layer of a scene, and its flags that are not what holds without them.
struct Flags<'s> {
    /// The layer as the scene writes it.
    spec: &'s LayerSpec,
    /// What these flags are called.
    names: Vec<&'static str>,
}

/// The options of a panel's layers, each without its flag of a number: so there are as many drawings as one
/// layer has flags, however many layers there are.
fn without(panel: &PanelPlan, flags: &[Option<Flags>], nth: usize) -> Vec<Option<Options>> {
    let of_layer = |(planned, flags): (&LayerPlan, &Option<Flags>)| {
        let flag = flags.as_ref()?.names.get(nth)?;
        Some(planned.options.without(flag))
    };
    panel.layers.iter().zip(flags).map(of_layer).collect()
}

/// Whether a scene gives a flag that does not hold without it. A word or a number says which thing is meant,
/// and may well name the usual one.
fn is_unusual(option: &OptionSpec, options: &Options) -> bool {
    let is_other =
        |usual: bool| option.default == usual.to_string() && options.flag(option.name, usual) != usual;
    matches!(option.takes, Takes::Flag) && (is_other(true) || is_other(false))
}

/// Whether two drawings of a panel differ in the layer of an index, or in its labels.
fn differ(one: &Sketched, other: &Sketched, index: usize) -> bool {
    let labels = |of: &Sketched| -> Vec<_> {
        let own = of.requests.iter().filter(|request| request.layer == index);
        own.map(|Request { label, shown, .. }| (label.clone(), *shown)).collect()
    };
    one.layers.get(index) != other.layers.get(index) || labels(one) != labels(other)
}

/// The note on an option, where it stands.
fn note(spec: &LayerSpec, layer: &'static str, option: &'static str) -> Option<Problem> {
    let (key, _) = spec.options.iter().find(|(key, _)| key.value == option)?;
    Some(Problem::new(Fault::IdleOption { layer, option }, key.span.clone()))
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::open_text;

    #[test]
    fn a_flag_that_changes_nothing_is_told_where_it_stands() {
        let told = |layer: &str| {
            let text = format!(
                "shapes.car = {{ kind = 'box', half_extents = [1, 0.5] }}
                 shapes.dog = {{ kind = 'polygon', vertices = [[0, 0], [1, 1], [0.3, 2]], position = [4, 0] }}
                 query = {{ kind = 'separation', of = ['car', 'dog'], algorithm = 'separating-axes' }}
                 panels = [{{ layers = ['shapes', {layer}] }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let notes = plan(&scene).unwrap().warnings;
            notes.iter().map(|p| format!("{} {}", &text[p.span.clone()], p.fault)).collect::<Vec<_>>()
        };
        let idle =
            |option: &str, layer: &str| [format!("{option} `{option}` of `{layer}` changes nothing here")];
        assert_eq!(told("{ layer = 'shapes', of = 'car', dotted = true }"), idle("dotted", "shapes"));
        assert_eq!(told("{ layer = 'shapes', dotted = false }"), [""; 0], "what holds without it");
        assert_eq!(told("{ layer = 'separation', points = true }"), [""; 0]);
        let two = "{ layer = 'shapes', of = 'car', dotted = true, centers = true },
                   { layer = 'shapes', of = 'car', dotted = true }";
        // What is told of one says nothing of the others.
        let both = told("{ layer = 'separation', rival = true, disc = true }");
        assert!(both.len() == 2 && both[1] == idle("rival", "separation")[0], "{both:?}");
        assert_eq!(told(two), [idle("dotted", "shapes"), idle("dotted", "shapes")].concat());
    }
}
