//! Where the module's memory comes from: blocks of powers of two, each kind with a list of those given back.
//!
//! A frame asks for tens of thousands of small blocks and gives them all back, in sizes that are those of the
//! frame before. Taking the head of a list is all that this needs; the allocator of the standard library,
//! which joins neighbours, takes twice the time of it and four times the code. A block is never split or
//! joined, so the memory is that of the fullest frame, rounded up.

use std::alloc::{GlobalAlloc, Layout};
use std::cell::UnsafeCell;
use std::ptr;

/// Bytes of the smallest block, and what every block is aligned to: nothing here asks for more.
const LEAST: usize = 16;
/// Kinds of blocks: 16 bytes, twice as many, and so on up to 2 GiB.
const KINDS: usize = 28;
/// Bytes that are asked of the host at once, at least.
const CHUNK: usize = 1 << 18;
/// Bytes of a page of the host's memory.
const PAGE: usize = 1 << 16;

/// A block that was given back, and the one given back before it.
struct Free {
    next: *mut Free,
}

/// The lists, and what was not given out yet.
struct Store {
    free: [*mut Free; KINDS],
    from: usize,
    to: usize,
}

/// The memory of the module.
pub(crate) struct Memory(UnsafeCell<Store>);

impl Memory {
    /// None yet.
    pub(crate) const fn new() -> Self {
        Self(UnsafeCell::new(Store { free: [ptr::null_mut(); KINDS], from: 0, to: 0 }))
    }
}

// SAFETY: a module without threads has one.
unsafe impl Sync for Memory {}

/// Which kind of block holds a layout.
fn kind(layout: Layout) -> usize {
    (layout.size().max(LEAST).next_power_of_two() / LEAST).trailing_zeros() as usize
}

impl Store {
    /// A block that no list has, or null where the host has no more memory.
    fn carve(&mut self, size: usize) -> *mut u8 {
        if self.to - self.from < size {
            let pages = size.max(CHUNK).div_ceil(PAGE);
            let before = core::arch::wasm32::memory_grow(0, pages);
            if before == usize::MAX {
                return ptr::null_mut();
            }
            // What is left of the piece before is too small for this, and goes on where it has grown.
            if before * PAGE != self.to {
                self.from = before * PAGE;
            }
            self.to = (before + pages) * PAGE;
        }
        let block = self.from;
        self.from += size;
        ptr::with_exposed_provenance_mut(block)
    }
}

// SAFETY: a block that is given out is in no list and is not carved again, and is as large and as aligned as
// its kind, which is that of its layout when it comes back.
unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let kind = kind(layout);
        if layout.align() > LEAST || kind >= KINDS {
            return ptr::null_mut();
        }
        // SAFETY: nobody else has the store, as nothing below asks for memory.
        let store = unsafe { &mut *self.0.get() };
        let head = store.free[kind];
        if head.is_null() {
            return store.carve(LEAST << kind);
        }
        // SAFETY: what a list has was given back, with its next one written in it.
        store.free[kind] = unsafe { (*head).next };
        head.cast()
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above; the block is large enough for what is written into it.
        let store = unsafe { &mut *self.0.get() };
        let head: *mut Free = block.cast();
        unsafe { (*head).next = store.free[kind(layout)] };
        store.free[kind(layout)] = head;
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let Ok(wanted) = Layout::from_size_align(size, layout.align()) else { return ptr::null_mut() };
        if kind(wanted) == kind(layout) {
            return block;
        }
        // SAFETY: both are large enough for what is copied.
        unsafe {
            let moved = self.alloc(wanted);
            if !moved.is_null() {
                ptr::copy_nonoverlapping(block, moved, size.min(layout.size()));
                self.dealloc(block, layout);
            }
            moved
        }
    }
}
