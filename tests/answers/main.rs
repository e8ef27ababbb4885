//! Answers of the solvers: on random pairs, on pairs without an obvious answer, on those that broke others,
//! and on the report's workloads.

#[path = "../asking/mod.rs"]
mod asking;
#[path = "../random_pairs/mod.rs"]
mod random_pairs;

mod contacts;
mod degenerate_pairs;
mod discrete_algorithms;
mod hard;
mod near_vertices;
mod polytope;
mod swapped;
mod workloads;
