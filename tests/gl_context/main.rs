//! Contexts of our own, of every way there is. In a process of their own: once OSMesa is loaded beside EGL, nobody can tell
//! which of them has the context of a host, and so `gl_guest` must be without it.

#[path = "../kit/mod.rs"]
mod kit;

mod context;
