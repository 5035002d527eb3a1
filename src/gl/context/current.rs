//! The context that is current on a thread, and changing it without losing the one before.

use std::cell::RefCell;
use std::rc::{Rc, Weak};

use super::egl;
use super::headless::Current;

thread_local! {
    /// The headless context that onionskin made current last on this thread. EGL and OSMesa do not know of each other,
    /// but share Mesa's current context, so each may believe that its own context still is current.
    static LAST: RefCell<Option<Weak<dyn Current>>> = const { RefCell::new(None) };
}

/// Someone is away from the context that was current before, and back when this is dropped.
#[derive(Default)]
pub(in crate::low_level::gl) struct Away(Option<(Rc<dyn Current>, Before)>);

enum Before {
    /// A headless one.
    Ours(Rc<dyn Current>),
    /// Someone else's, by EGL.
    Host(egl::Binding),
}

impl std::fmt::Debug for Away {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.0.is_some() { "Away" } else { "At home" })
    }
}

/// Whether it is current, and Mesa agrees.
pub(super) fn is_current(context: &Rc<dyn Current>) -> bool {
    is_last(context) && context.is_current()
}

fn is_last(context: &Rc<dyn Current>) -> bool {
    LAST.with_borrow(|last| {
        last.as_ref()
            .is_some_and(|last| std::ptr::addr_eq(last.as_ptr(), Rc::as_ptr(context)))
    })
}

/// Makes a headless context current, until the answer is dropped.
pub(super) fn enter(context: &Rc<dyn Current>) -> Result<Away, String> {
    if is_current(context) {
        return Ok(Away::default());
    }
    let before = leave();
    let away = Away(before.map(|before| (context.clone(), before)));
    context.make_current()?;
    remember(context);
    Ok(away)
}

/// A context that was made just now is current.
pub(super) fn remember(context: &Rc<dyn Current>) {
    LAST.set(Some(Rc::downgrade(context)));
}

/// Nothing is current, until the answer is dropped.
pub(super) fn set_aside() -> Suspended {
    Suspended(leave())
}

/// What was current comes back when this is dropped, unless it is [`forget`](Self::forget)ten.
pub(super) struct Suspended(Option<Before>);

impl Suspended {
    pub(super) fn forget(mut self) {
        self.0 = None;
    }
}

impl Drop for Suspended {
    fn drop(&mut self) {
        if let Some(before) = self.0.take() {
            before.come_back();
        }
    }
}

/// Releases the current context.
fn leave() -> Option<Before> {
    let last = LAST.take().and_then(|last| last.upgrade());
    let before = match last {
        Some(last) if last.is_current() => {
            last.release();
            Some(Before::Ours(last))
        }
        _ => None,
    };
    // A host may have made its own current in the meantime.
    before.or_else(|| egl::leave().map(Before::Host))
}

impl Before {
    fn come_back(self) {
        match self {
            Self::Ours(context) => {
                if context.make_current().is_ok() {
                    remember(&context);
                }
            }
            Self::Host(binding) => binding.come_back(),
        }
    }
}

impl Drop for Away {
    fn drop(&mut self) {
        if let Some((here, before)) = self.0.take() {
            here.release();
            before.come_back();
        }
    }
}
