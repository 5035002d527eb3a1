//! The trait of EGL's and OSMesa's contexts.

/// A headless context. It ends when this is dropped.
pub(super) trait Current {
    /// The address of a function.
    fn function(&self, name: &str) -> *const std::ffi::c_void;

    /// Whether its library has it current on this thread.
    fn is_current(&self) -> bool;

    /// Makes it current on this thread, on which no other library may have a current context.
    fn make_current(&self) -> Result<(), String>;

    /// Releases it.
    fn release(&self);
}
