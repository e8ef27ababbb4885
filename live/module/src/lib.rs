//! tracefig in a browser: figures that are edited and drawn again, through a plain C ABI without imports.
//!
//! A page writes a text into [`tf_input`]'s room and calls [`tf_open`] or [`tf_set`]; [`tf_draw`] leaves the
//! picture in [`tf_out`] and what it says in [`tf_info`]. Places and lengths are those of the module's memory
//! and hold until the next call. After a trap the module is of no use any more: make a new instance.
//!
//! All that is unsafe is here: the names are exported as they are, and nothing else of the program has one.

#[cfg(target_arch = "wasm32")]
mod memory;

use std::cell::RefCell;

use tracefig::live::{Frame, Live, Refusal};

/// What the page and the module share.
#[derive(Default)]
struct Desk {
    /// What the page has written.
    input: Vec<u8>,
    /// The figure that is open.
    live: Option<Live>,
    /// The picture as last drawn.
    out: String,
    /// What it says, or why the last call was refused.
    info: String,
}

impl Desk {
    /// The answer to a call, 1 or 0; why it was refused stands in the info.
    fn told(&mut self, done: Result<(), Refusal>) -> u32 {
        match done {
            Ok(()) => 1,
            Err(refusal) => self.refused(&refusal.to_string()),
        }
    }

    /// The answer to a call that can't be done.
    fn refused(&mut self, why: &str) -> u32 {
        self.info = Refusal::panel(why);
        0
    }

    /// Does something with the text that the page has written.
    fn with_input(&mut self, act: impl FnOnce(&mut Self, &str) -> Result<(), Refusal>) -> u32 {
        match String::from_utf8(std::mem::take(&mut self.input)) {
            Ok(text) => {
                let done = act(self, &text);
                self.told(done)
            }
            Err(_) => self.refused("the input is not UTF-8"),
        }
    }
}

#[cfg(target_arch = "wasm32")]
#[global_allocator]
static MEMORY: memory::Memory = memory::Memory::new();

thread_local!(static DESK: RefCell<Desk> = RefCell::default());

/// Room for `len` bytes of UTF-8, which the next call reads.
// SAFETY: no other item of the program is called so; as for all below.
#[unsafe(no_mangle)]
pub extern "C" fn tf_input(len: usize) -> *mut u8 {
    DESK.with_borrow_mut(|desk| {
        desk.input = vec![b' '; len];
        desk.input.as_mut_ptr()
    })
}

/// Opens the figure that the input describes ([`Live::open`]): 1, or 0 where it is none.
#[unsafe(no_mangle)]
pub extern "C" fn tf_open() -> u32 {
    DESK.with_borrow_mut(|desk| {
        desk.with_input(|desk, text| {
            desk.live = Some(Live::open(text)?);
            Ok(())
        })
    })
}

/// Makes the edits that the input lists ([`Live::set`]): 1, or 0 where the scene would be none and stays as
/// it was.
#[unsafe(no_mangle)]
pub extern "C" fn tf_set() -> u32 {
    DESK.with_borrow_mut(|desk| {
        desk.with_input(|desk, text| desk.live.as_mut().map_or(Err(Refusal::Closed), |live| live.set(text)))
    })
}

/// Shows the figure up to a step, from 1, from the next [`tf_draw`] on; 0xFFFF_FFFF shows it finished.
#[unsafe(no_mangle)]
pub extern "C" fn tf_step(step: u32) {
    let step = if step == u32::MAX { None } else { usize::try_from(step).ok() };
    DESK.with_borrow_mut(|desk| desk.live.iter_mut().for_each(|live| live.show(step)));
}

/// Places labels afresh in the next picture ([`Live::rest`]): it has the bytes of the scene's file.
#[unsafe(no_mangle)]
pub extern "C" fn tf_rest() {
    DESK.with_borrow_mut(|desk| desk.live.iter_mut().for_each(Live::rest));
}

/// Draws the scene as it is now ([`Live::draw`]): 1, or 0 where it can't be, and then it is again as it was
/// drawn last, and so is the picture.
#[unsafe(no_mangle)]
pub extern "C" fn tf_draw() -> u32 {
    DESK.with_borrow_mut(|desk| {
        let drawn = desk.live.as_mut().map_or(Err(Refusal::Closed), Live::draw);
        let done = drawn.map(|Frame { svg, panel }| (desk.out, desk.info) = (svg, panel));
        desk.told(done)
    })
}

/// Where the picture as last drawn begins: an SVG in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn tf_out() -> *const u8 {
    DESK.with_borrow(|desk| desk.out.as_ptr())
}

/// Bytes of the picture.
#[unsafe(no_mangle)]
pub extern "C" fn tf_out_len() -> usize {
    DESK.with_borrow(|desk| desk.out.len())
}

/// Where what the last call has to say begins: JSON in UTF-8, with an `error` where it was refused.
#[unsafe(no_mangle)]
pub extern "C" fn tf_info() -> *const u8 {
    DESK.with_borrow(|desk| desk.info.as_ptr())
}

/// Bytes of what the last call has to say.
#[unsafe(no_mangle)]
pub extern "C" fn tf_info_len() -> usize {
    DESK.with_borrow(|desk| desk.info.len())
}
