//! The runs of a plan: the scene's own, the one that texts of the whole figure are of, and all.

use std::sync::Arc;

use super::panel::PanelPlan;
use super::plan::Plan;
use super::runs::Run;
use super::whole::of_the_whole;

impl Plan<'_> {
    /// The scene's own run, at the query's moment.
    #[must_use]
    pub(crate) fn own_run(&self) -> Arc<Run> {
        self.runs.own(self.scene, self.scene.query.time)
    }

    /// All runs that the figure needed so far, in the order in which they were asked for.
    #[must_use]
    pub(crate) fn all_runs(&self) -> Vec<Arc<Run>> {
        self.runs.all()
    }

    /// The run that texts of the whole figure are of.
    pub(super) fn run_of_the_whole(&self) -> Arc<Run> {
        self.runs.own(self.scene, self.of_the_whole().map_or(0.0, |panel| panel.moment.time))
    }

    /// The panel whose moment texts of the whole figure are of.
    pub(super) fn of_the_whole(&self) -> Option<&PanelPlan<'_>> {
        of_the_whole(self.scene, &self.panels)
    }
}
