//! What is allocated: nothing by an untraced query, a band of rows by a PNG.

#[path = "../asking/mod.rs"]
mod asking;
#[path = "../random_pairs/mod.rs"]
mod random_pairs;

mod allocation;
mod drawing;
