//! The state that calls set and draws use, with GL's initial values.

use crate::steps::{BlendFactor, Call, Capability, Compare, StencilOp};

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

/// `glBlendFuncSeparate`
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend {
    pub(super) src_rgb: BlendFactor,
    pub(super) dst_rgb: BlendFactor,
    pub(super) src_alpha: BlendFactor,
    pub(super) dst_alpha: BlendFactor,
}

impl Blend {
    /// Whether this is front-to-back compositing: `(ONE_MINUS_DST_ALPHA, ONE)` for color and alpha.
    pub(super) fn is_under(&self) -> bool {
        let source = [self.src_rgb, self.src_alpha];
        let destination = [self.dst_rgb, self.dst_alpha];
        source == [BlendFactor::OneMinusDstAlpha; 2] && destination == [BlendFactor::One; 2]
    }
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
    pub(super) blend: Option<Blend>,
    blend_func: Blend,
    pub(super) color_mask: [bool; 4],
    pub(super) clear_color: [f32; 4],
    pub(super) clear_depth: f64,
    pub(super) clear_stencil: i32,
    /// The comparison of texture unit 0's shadow lookup.
    pub(super) compare_func: Compare,
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
            blend: None,
            blend_func: Blend {
                src_rgb: BlendFactor::One,
                dst_rgb: BlendFactor::Zero,
                src_alpha: BlendFactor::One,
                dst_alpha: BlendFactor::Zero,
            },
            color_mask: [true; 4],
            clear_color: [0.0; 4],
            clear_depth: 1.0,
            clear_stencil: 0,
            compare_func: Compare::Lequal,
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
            }
            | Call::ColorMaski {
                buf: 0,
                red,
                green,
                blue,
                alpha,
            } => self.color_mask = [red, green, blue, alpha],
            Call::StencilMask { mask } => self.stencil_mask = mask,
            Call::StencilFunc {
                func,
                reference,
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
                self.set_blend(sfactor, dfactor, sfactor, dfactor);
            }
            Call::BlendFuncSeparate {
                src_rgb,
                dst_rgb,
                src_alpha,
                dst_alpha,
            } => self.set_blend(src_rgb, dst_rgb, src_alpha, dst_alpha),
            Call::SamplerCompareFunc { func } => self.compare_func = func,
            _ => return false,
        }
        true
    }

    fn enable(&mut self, cap: Capability, on: bool) {
        match cap {
            Capability::DepthTest => self.depth_test = on,
            Capability::StencilTest => self.stencil_test = on.then_some(self.stencil_func),
            Capability::Blend => self.blend = on.then_some(self.blend_func),
            // The depths of an emulated pixel are given, from 0 to 1.
            Capability::DepthClamp => {}
        }
    }

    fn set_blend(
        &mut self,
        src_rgb: BlendFactor,
        dst_rgb: BlendFactor,
        src_alpha: BlendFactor,
        dst_alpha: BlendFactor,
    ) {
        self.blend_func = Blend {
            src_rgb,
            dst_rgb,
            src_alpha,
            dst_alpha,
        };
        self.enable(Capability::Blend, self.blend.is_some());
    }
}
