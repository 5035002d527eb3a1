//! The bytes of an A-buffer's pool, read back after the frame.

use std::cell::RefCell;
use std::rc::Rc;

use onionskin::low_level::gl::GlMachine;
use onionskin::low_level::methods::{ABufferOptions, Algorithm, Drawn, Entry, Setup, Technique};
use onionskin::low_level::papers::lindholm_2015::RECORDS;
use onionskin::{Renderer, Result, Scene};

/// An A-buffer that hands out its pool.
#[derive(Debug)]
struct Watched {
    options: ABufferOptions,
    pool: Rc<RefCell<Vec<u8>>>,
}

struct Watching {
    inner: Box<dyn Algorithm>,
    pool: Rc<RefCell<Vec<u8>>>,
}

impl Technique for Watched {
    fn entry(&self) -> &'static Entry {
        self.options.entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(Watching {
            inner: self.options.algorithm(setup),
            pool: self.pool.clone(),
        })
    }
}

impl Algorithm for Watching {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        self.inner.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let drawn = self.inner.draw(machine, scene)?;
        *self.pool.borrow_mut() = machine.read_storage(RECORDS)?;
        Ok(drawn)
    }
}

/// The pool of a frame with one band.
pub fn records(renderer: &mut Renderer<'_>, scene: &Scene, options: ABufferOptions) -> Vec<u8> {
    let pool = Rc::new(RefCell::new(Vec::new()));
    let watched = Watched {
        options,
        pool: pool.clone(),
    };
    renderer.render(scene, &watched).unwrap();
    pool.take()
}
