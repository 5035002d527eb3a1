//! What EGL's and OSMesa's contexts have in common.

/// What keeps a headless context alive; ends it when dropped.
pub(super) trait Current {
    /// Where the functions are.
    fn function(&self, name: &str) -> *const std::ffi::c_void;

    /// Whether its library has it current on this thread.
    fn is_current(&self) -> bool;

    /// Makes it current on this thread, where no other library has a context current.
    fn make_current(&self) -> Result<(), String>;

    /// Makes it current no more.
    fn release(&self);
}
