//! Making GL objects and allocating their memory. Every allocation is checked, and its error says its purpose.

use glow::HasContext;

use super::constants::error_name;
use crate::error::{Error, Result};

/// Objects that are being made. They are deleted if this is dropped before [`finish`](Self::finish), so that a failure
/// halfway leaves nothing behind.
pub(super) struct Making<'g> {
    gl: &'g glow::Context,
    made: Vec<Object>,
}

enum Object {
    Buffer(glow::Buffer),
    Texture(glow::Texture),
    VertexArray(glow::VertexArray),
    Sampler(glow::Sampler),
    Program(glow::Program),
}

impl<'g> Making<'g> {
    /// The context is current.
    pub(super) fn new(gl: &'g glow::Context) -> Self {
        let made = Vec::new();
        Self { gl, made }
    }

    pub(super) fn gl(&self) -> &'g glow::Context {
        self.gl
    }

    pub(super) fn buffer(&mut self) -> Result<glow::Buffer> {
        // SAFETY: the context is current, here and in the functions below.
        let raw = named("buffer", unsafe { self.gl.create_buffer() })?;
        self.made.push(Object::Buffer(raw));
        Ok(raw)
    }

    pub(super) fn texture(&mut self) -> Result<glow::Texture> {
        // SAFETY: as above.
        let raw = named("texture", unsafe { self.gl.create_texture() })?;
        self.made.push(Object::Texture(raw));
        Ok(raw)
    }

    pub(super) fn vertex_array(&mut self) -> Result<glow::VertexArray> {
        // SAFETY: as above.
        let raw = named("vertex array", unsafe { self.gl.create_vertex_array() })?;
        self.made.push(Object::VertexArray(raw));
        Ok(raw)
    }

    pub(super) fn sampler(&mut self) -> Result<glow::Sampler> {
        // SAFETY: as above.
        let raw = named("sampler", unsafe { self.gl.create_sampler() })?;
        self.made.push(Object::Sampler(raw));
        Ok(raw)
    }

    pub(super) fn program(&mut self) -> Result<glow::Program> {
        // SAFETY: as above.
        let raw = named("program", unsafe { self.gl.create_program() })?;
        self.made.push(Object::Program(raw));
        Ok(raw)
    }

    /// All objects are made, and belong to the caller from now on.
    pub(super) fn finish(mut self) {
        self.made.clear();
    }
}

impl Drop for Making<'_> {
    fn drop(&mut self) {
        for object in self.made.drain(..) {
            // SAFETY: the context is current; the object was made here and is nobody else's.
            unsafe {
                match object {
                    Object::Buffer(raw) => self.gl.delete_buffer(raw),
                    Object::Texture(raw) => self.gl.delete_texture(raw),
                    Object::VertexArray(raw) => self.gl.delete_vertex_array(raw),
                    Object::Sampler(raw) => self.gl.delete_sampler(raw),
                    Object::Program(raw) => self.gl.delete_program(raw),
                }
            }
        }
    }
}

/// An object's name, or an error if there was none left. Drivers give out names until they have lost their device.
pub(super) fn named<T>(kind: &str, made: Result<T, String>) -> Result<T> {
    made.map_err(|what| Error::Lost {
        doing: format!("make a {kind}"),
        answer: what,
    })
}

/// Lets `call` allocate `bytes` for `what`, and asks whether there was enough memory. The context is current.
///
/// # Errors
/// If there was too little memory. An error that was pending before is not blamed on the allocation, but is an error,
/// too.
pub(super) fn allocate(
    gl: &glow::Context,
    what: &str,
    bytes: u64,
    call: impl FnOnce(),
) -> Result<()> {
    expect_no_error(gl, &format!("before there was room for {what}"))?;
    call();
    match take_error(gl) {
        None => Ok(()),
        Some(error) => Err(no_room(what, bytes, error)),
    }
}

/// The error that there is too little memory for something.
pub(super) fn no_room(what: &str, bytes: u64, error: &str) -> Error {
    Error::Driver {
        what: format!("the driver has no room for {what} ({}): {error}", size(bytes)),
        remedy: "render a smaller image or a simpler scene, give lists a smaller byte budget, or free memory".into(),
    }
}

/// # Errors
/// OpenGL's errors since they were last asked for, if there are any. `when` completes the sentence.
pub(super) fn expect_no_error(gl: &glow::Context, when: &str) -> Result<()> {
    let errors = take_errors(gl);
    if errors.is_empty() {
        return Ok(());
    }
    let remedy = if errors.contains(&error_name(glow::OUT_OF_MEMORY)) {
        "the driver is out of memory: render a smaller image or a simpler scene, or free memory"
    } else {
        "this is a fault of onionskin's or of the driver's: please report it with what `onionskin doctor` says"
    };
    Err(Error::Driver {
        what: format!("OpenGL says {} {when}", errors.join(", ")),
        remedy: remedy.into(),
    })
}

/// OpenGL's errors since they were last asked for, by their names.
pub(super) fn take_errors(gl: &glow::Context) -> Vec<&'static str> {
    // A lost context reports its loss again and again.
    const MOST: usize = 16;
    std::iter::from_fn(|| take_error(gl)).take(MOST).collect()
}

fn take_error(gl: &glow::Context) -> Option<&'static str> {
    // SAFETY: the context is current.
    match unsafe { gl.get_error() } {
        glow::NO_ERROR => None,
        error => Some(error_name(error)),
    }
}

/// A number of bytes, for people.
fn size(bytes: u64) -> String {
    const KIB: f64 = 1024.0;
    match bytes as f64 {
        few if few < KIB => format!("{bytes} bytes"),
        some if some < KIB * KIB => format!("{:.1} KiB", some / KIB),
        many => format!("{:.1} MiB", many / (KIB * KIB)),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn sizes_are_said_in_the_unit_that_keeps_them_short() {
        let said = [0, 1023, 1024, 12_897_485, 3 << 30].map(super::size);
        assert_eq!(
            said,
            ["0 bytes", "1023 bytes", "1.0 KiB", "12.3 MiB", "3072.0 MiB"]
        );
    }
}
