//! The state that calls set and draws use, with GL's initial values.

use crate::steps::{BlendEquation, BlendFactor, Call, Capability, Compare, Number, StencilOp};

/// OpenGL promises so many color maps of a framebuffer.
const MOST_COLORS: usize = 8;

/// `glStencilFunc`
#[derive(Clone, Copy, Debug)]
pub(super) struct StencilTest {
    pub(super) func: Compare,
    pub(super) reference: i32,
    pub(super) mask: u32,
}

/// `glStencilOp`
#[derive(Clone, Copy, Debug)]
pub(super) struct StencilOps {
    pub(super) sfail: StencilOp,
    pub(super) dpfail: StencilOp,
    pub(super) dppass: StencilOp,
}

/// `glBlendEquation` and `glBlendFuncSeparate`
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend {
    pub(super) equation: BlendEquation,
    pub(super) src_rgb: BlendFactor,
    pub(super) dst_rgb: BlendFactor,
    pub(super) src_alpha: BlendFactor,
    pub(super) dst_alpha: BlendFactor,
}

impl Blend {
    fn set_factors(&mut self, [src_rgb, dst_rgb, src_alpha, dst_alpha]: [BlendFactor; 4]) {
        *self = Self {
            equation: self.equation,
            src_rgb,
            dst_rgb,
            src_alpha,
            dst_alpha,
        };
    }

    /// Whether this is front-to-back compositing: `(ONE_MINUS_DST_ALPHA, ONE)` for color and alpha.
    pub(super) fn is_under(&self) -> bool {
        let source = [self.src_rgb, self.src_alpha];
        let destination = [self.dst_rgb, self.dst_alpha];
        self.equation == BlendEquation::FuncAdd
            && source == [BlendFactor::OneMinusDstAlpha; 2]
            && destination == [BlendFactor::One; 2]
    }
}

/// The state of one color map of the framebuffer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Buffer {
    pub(super) blend: Blend,
    pub(super) color_mask: [bool; 4],
}

/// All state that is a value and not an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) depth_test: bool,
    pub(super) depth_func: Compare,
    pub(super) depth_mask: bool,
    pub(super) stencil_test: Option<StencilTest>,
    stencil_func: StencilTest,
    pub(super) stencil_ops: StencilOps,
    pub(super) stencil_mask: u32,
    /// Whether colours are blended.
    pub(super) blend: bool,
    pub(super) buffers: [Buffer; MOST_COLORS],
    pub(super) clear_color: [f32; 4],
    pub(super) clear_depth: f64,
    pub(super) clear_stencil: i32,
}

impl State {
    pub(super) const INITIAL: Self = {
        let stencil_func = StencilTest {
            func: Compare::Always,
            reference: 0,
            mask: 0xFF,
        };
        Self {
            depth_test: false,
            depth_func: Compare::Less,
            depth_mask: true,
            stencil_test: None,
            stencil_func,
            stencil_ops: StencilOps {
                sfail: StencilOp::Keep,
                dpfail: StencilOp::Keep,
                dppass: StencilOp::Keep,
            },
            stencil_mask: 0xFF,
            blend: false,
            buffers: [Buffer {
                blend: Blend {
                    equation: BlendEquation::FuncAdd,
                    src_rgb: BlendFactor::One,
                    dst_rgb: BlendFactor::Zero,
                    src_alpha: BlendFactor::One,
                    dst_alpha: BlendFactor::Zero,
                },
                color_mask: [true; 4],
            }; MOST_COLORS],
            clear_color: [0.0; 4],
            clear_depth: 1.0,
            clear_stencil: 0,
        }
    };

    /// Performs a call that only sets state. Returns false for any other call.
    pub(super) fn set(&mut self, call: &Call) -> bool {
        match *call {
            Call::ClearColor {
                red,
                green,
                blue,
                alpha,
            } => self.clear_color = [red, green, blue, alpha],
            Call::ClearDepth { depth } => self.clear_depth = depth,
            Call::ClearStencil { s } => self.clear_stencil = s,
            Call::Enable { cap } => self.enable(cap, true),
            Call::Disable { cap } => self.enable(cap, false),
            Call::DepthFunc { func } => self.depth_func = func,
            Call::DepthMask { flag } => self.depth_mask = flag,
            Call::ColorMask {
                red,
                green,
                blue,
                alpha,
            } => {
                let mask = [red, green, blue, alpha];
                self.each_buffer(|buffer| buffer.color_mask = mask);
            }
            Call::ColorMaski {
                buf,
                red,
                green,
                blue,
                alpha,
            } => {
                let mask = [red, green, blue, alpha];
                return self.one_buffer(buf, |buffer| buffer.color_mask = mask);
            }
            Call::StencilMask { mask } => self.stencil_mask = mask,
            Call::StencilFunc {
                func,
                reference,
                mask,
            }
            | Call::StencilReference {
                func,
                reference: Number::Known(reference),
                mask,
            } => {
                self.stencil_func = StencilTest {
                    func,
                    reference,
                    mask,
                };
                self.enable(Capability::StencilTest, self.stencil_test.is_some());
            }
            Call::StencilOp {
                sfail,
                dpfail,
                dppass,
            } => {
                self.stencil_ops = StencilOps {
                    sfail,
                    dpfail,
                    dppass,
                };
            }
            Call::BlendFunc { sfactor, dfactor } => {
                let factors = [sfactor, dfactor, sfactor, dfactor];
                self.each_buffer(|buffer| buffer.blend.set_factors(factors));
            }
            Call::BlendFuncSeparate {
                src_rgb,
                dst_rgb,
                src_alpha,
                dst_alpha,
            } => {
                let factors = [src_rgb, dst_rgb, src_alpha, dst_alpha];
                self.each_buffer(|buffer| buffer.blend.set_factors(factors));
            }
            Call::BlendFunci { buf, src, dst } => {
                return self.one_buffer(buf, |it| it.blend.set_factors([src, dst, src, dst]));
            }
            Call::BlendEquationi { buf, mode } => {
                return self.one_buffer(buf, |buffer| buffer.blend.equation = mode);
            }
            _ => return false,
        }
        true
    }

    fn enable(&mut self, cap: Capability, on: bool) {
        match cap {
            Capability::DepthTest => self.depth_test = on,
            Capability::StencilTest => self.stencil_test = on.then_some(self.stencil_func),
            Capability::Blend => self.blend = on,
            // The depths of an emulated pixel are given, from 0 to 1.
            Capability::DepthClamp => {}
        }
    }

    fn each_buffer(&mut self, set: impl Fn(&mut Buffer)) {
        self.buffers.iter_mut().for_each(set);
    }

    /// Returns false if there is no such buffer.
    fn one_buffer(&mut self, number: u32, set: impl FnOnce(&mut Buffer)) -> bool {
        self.buffers.get_mut(number as usize).map(set).is_some()
    }
}
