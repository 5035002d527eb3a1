//! The calls: one table with one line per call.
//!
//! From a line the macro makes the call's variant of [`Call`], its constructor for listings, its printed text, and the
//! functions that read its arguments: the names in them, and the values of their variables. What a call *does* is up to
//! each machine.
//!
//! If OpenGL has the call, the spelling is OpenGL's.

use std::fmt;

use super::argument::{Argument, Values};
use super::classic::*;
use super::constants::*;
use super::names::{Map, Name, Number, Query, Shader, Storage, Target};
use crate::error::Result;

/// A line is `Variant: constructor(argument: Type, ...);`, and the call is printed like that. If the printed text
/// differs, it follows: `=> "name"(argument, other name = value, ...)`.
///
/// The head names the enum, the module of its constructors, and the function that makes a [`Call`] from a constructor's
/// result.
macro_rules! calls {
    (
        $(#[$about:meta])*
        $enum:ident in $functions:ident as $call:path {
            $(
                $(#[$doc:meta])*
                $variant:ident: $function:ident($($($field:ident: $type:ty),+)?)
                    $(=> $name:tt($($shown:ident $(= $value:expr)?),*))?;
            )*
        }
        $(or $(#[$more_doc:meta])* $more:ident($inner:ty))?
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(missing_docs)] // OpenGL's calls and its parameters' names; what OpenGL does not have is documented
        #[non_exhaustive]
        pub enum $enum {
            $($(#[$doc])* $variant $({ $($field: $type),+ })?,)*
            $($(#[$more_doc])* $more($inner),)?
        }

        /// The constructors.
        #[allow(non_snake_case, missing_docs)] // as above
        pub(super) mod $functions {
            use super::*;

            $(
                $(#[$doc])*
                pub const fn $function($($($field: $type),+)?) -> Call {
                    $call($enum::$variant $({ $($field),+ })?)
                }
            )*
        }

        impl $enum {
            /// The call's name in OpenGL or in its paper, and its arguments' names and values.
            pub fn signature(&self) -> (&'static str, Vec<(&'static str, String)>) {
                match self {
                    $(Self::$variant $({ $($field),+ })? => printed!(
                        $function [$($($field)+)?] $($name [$($shown $(= $value)?),*])?
                    ),)*
                    $(Self::$more(call) => <$inner>::signature(call),)?
                }
            }

            /// Everything that the call names, in the order of its arguments.
            pub fn names(&self) -> impl Iterator<Item = Name> + use<> {
                let mut found = Vec::new();
                match self {
                    $(Self::$variant $({ $($field),+ })? => { $($($field.names(&mut found);)+)? })*
                    $(Self::$more(call) => found.extend(<$inner>::names(call)),)?
                }
                found.into_iter()
            }

            /// The call with its variables replaced by their values.
            pub(super) fn resolved(&self, values: Values<'_>) -> Result<Self> {
                Ok(match self {
                    $(Self::$variant $({ $($field),+ })? => {
                        Self::$variant $({ $($field: $field.resolved(values)?),+ })?
                    })*
                    $(Self::$more(call) => Self::$more(<$inner>::resolved(call, values)?),)?
                })
            }
        }

        impl fmt::Display for $enum {
            /// Prints the call with its arguments named: `glDepthFunc(func = GL_LESS)`.
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let (name, arguments) = self.signature();
                let named: Vec<_> = arguments
                    .iter()
                    .map(|(name, value)| format!("{name} = {value}"))
                    .collect();
                write!(f, "{name}({})", named.join(", "))
            }
        }
    };
}

/// A call's name and arguments as they are printed: those of the line, or those after its `=>`.
macro_rules! printed {
    ($function:ident [$($field:ident)*]) => {
        (stringify!($function), vec![$((stringify!($field), $field.text())),*])
    };
    ($function:ident [$($field:ident)*] $name:tt [$($shown:ident $(= $value:expr)?),*]) => {
        ($name, vec![$((stringify!($shown), printed!(@ $shown $(= $value)?))),*])
    };
    (@ $shown:ident) => { $shown.text() };
    (@ $shown:ident = $value:expr) => { $value.text() };
}

calls! {
    /// One call.
    Call in functions as itself {
        ClearColor: glClearColor(red: f32, green: f32, blue: f32, alpha: f32);
        ClearDepth: glClearDepth(depth: f64);
        ClearStencil: glClearStencil(s: i32);
        Clear: glClear(mask: Buffers);
        Enable: glEnable(cap: Capability);
        Disable: glDisable(cap: Capability);
        DepthFunc: glDepthFunc(func: Compare);
        DepthMask: glDepthMask(flag: bool);
        ColorMask: glColorMask(red: bool, green: bool, blue: bool, alpha: bool);
        /// `glColorMask` for one of several color maps.
        ColorMaski: glColorMaski(buf: u32, red: bool, green: bool, blue: bool, alpha: bool);
        StencilMask: glStencilMask(mask: u32) => "glStencilMask"(mask = bits(*mask));
        StencilFunc: glStencilFunc(func: Compare, reference: i32, mask: u32)
            => "glStencilFunc"(func, ref = reference, mask = bits(*mask));
        /// `glStencilFunc` with a computed reference.
        StencilReference: stencilReference(func: Compare, reference: Number<i32>, mask: u32)
            => "glStencilFunc"(func, ref = reference, mask = bits(*mask));
        StencilOp: glStencilOp(sfail: StencilOp, dpfail: StencilOp, dppass: StencilOp);
        BlendFunc: glBlendFunc(sfactor: BlendFactor, dfactor: BlendFactor);
        BlendFuncSeparate: glBlendFuncSeparate(src_rgb: BlendFactor, dst_rgb: BlendFactor, src_alpha: BlendFactor, dst_alpha: BlendFactor)
            => "glBlendFuncSeparate"(srcRGB = src_rgb, dstRGB = dst_rgb, srcAlpha = src_alpha, dstAlpha = dst_alpha);
        /// `glBlendEquation` for one of several color maps.
        BlendEquationi: glBlendEquationi(buf: u32, mode: BlendEquation);
        /// `glBlendFunc` for one of several color maps.
        BlendFunci: glBlendFunci(buf: u32, src: BlendFactor, dst: BlendFactor);
        /// `glClearBufferfv` with `GL_COLOR`, the four channels one by one.
        ClearFloats: glClearBufferfv(drawbuffer: u32, value: [f32; 4])
            => "glClearBufferfv"(buffer = "GL_COLOR", drawbuffer, value);
        /// `glClearBufferuiv` with `GL_COLOR` and zeros.
        ClearIntegers: glClearBufferuiv(drawbuffer: u32)
            => "glClearBufferuiv"(buffer = "GL_COLOR", drawbuffer, value = "{0, 0, 0, 0}");
        /// Listing 1's 'depth unit n': the calls that follow go to that unit, as after ARB_multitexture's
        /// `glActiveTexture`. No OpenGL has it; [`DepthUnits`](crate::steps::DepthUnits) lowers it.
        ActiveDepthUnit: activeDepthUnit(unit: u8);
        /// Listing 1's 'bind buffer': gives the active depth unit its buffer. Lowered likewise.
        BindDepthBuffer: bindDepthBuffer(buffer: Map);
        ActiveTexture: glActiveTexture(unit: u32)
            => "glActiveTexture"(texture = format!("GL_TEXTURE{unit}"));
        BindTexture: glBindTexture(texture: Map)
            => "glBindTexture"(target = "GL_TEXTURE_2D", texture);
        /// `glSamplerParameteri` with `GL_TEXTURE_COMPARE_FUNC`, on the sampler of texture unit 0, whose compare mode
        /// is always on: the shadow lookup. It is set on a sampler and not on the texture, so that another unit can
        /// look up the same depth buffer as plain numbers.
        SamplerCompareFunc: glSamplerCompareFunc(func: Compare)
            => "glSamplerParameteri"(sampler = "shadow", pname = "GL_TEXTURE_COMPARE_FUNC", param = func);
        UseProgram: glUseProgram(program: Shader);
        /// `glUseProgram` with the one of a row of programs whose Local Array has so many elements (Lindholm et al.
        /// 2015, section 5.1: "the individual instances only differ by a single number").
        UseProgramOfSize: useProgramOfSize(program: Shader, size: Number<u32>)
            => "glUseProgram"(program, N = size);
        /// `glUniform1f` of the current program. The value is that of the listing's variable with the uniform's name.
        Uniform: uniform(name: &'static str, value: Number<f32>)
            => "glUniform1f"(location = name, v0 = value);
        /// `glBindImageTexture`, for reading and writing.
        BindImage: glBindImageTexture(unit: u32, texture: Map)
            => "glBindImageTexture"(unit, texture, access = "GL_READ_WRITE");
        /// `glBindBufferBase` with `GL_SHADER_STORAGE_BUFFER`.
        BindStorage: glBindStorageBuffer(index: u32, buffer: Storage)
            => "glBindBufferBase"(target = "GL_SHADER_STORAGE_BUFFER", index, buffer);
        /// `glMemoryBarrier` with `GL_ALL_BARRIER_BITS`.
        MemoryBarrier: glMemoryBarrier() => "glMemoryBarrier"(barriers = "GL_ALL_BARRIER_BITS");
        BindFramebuffer: glBindFramebuffer(framebuffer: Target)
            => "glBindFramebuffer"(target = "GL_FRAMEBUFFER", framebuffer);
        /// `glFramebufferTexture2D` with `GL_COLOR_ATTACHMENT0`.
        AttachColor: glFramebufferColor(texture: Map)
            => "glFramebufferTexture2D"(target = "GL_FRAMEBUFFER", attachment = "GL_COLOR_ATTACHMENT0", textarget = "GL_TEXTURE_2D", texture);
        /// `glFramebufferTexture2D` with `GL_DEPTH_STENCIL_ATTACHMENT`.
        AttachDepth: glFramebufferDepth(texture: Map)
            => "glFramebufferTexture2D"(target = "GL_FRAMEBUFFER", attachment = "GL_DEPTH_STENCIL_ATTACHMENT", textarget = "GL_TEXTURE_2D", texture);
        BeginQuery: glBeginQuery(query: Query)
            => "glBeginQuery"(target = "GL_SAMPLES_PASSED", id = query);
        EndQuery: glEndQuery(query: Query)
            => "glEndQuery"(target = "GL_SAMPLES_PASSED", id = query);
        /// `glCopyImageSubData` of a whole image, every aspect. A destination that does not exist yet is made.
        CopyImage: glCopyImageSubData(from: Map, to: Map)
            => "glCopyImageSubData"(src = from, dst = to);
        /// `swap(a, b)`: from here on each of two maps has the other's name. Bindings and attachments do not change.
        Swap: swap(a: Map, b: Map);
        /// Draws all of these objects.
        Draw: draw(objects: Objects) => (objects.drawn_by())();
    }
    or
    /// A call of the OpenGL of 2001.
    Classic(ClassicCall)
}

calls! {
    /// A call of the OpenGL of 2001.
    ClassicCall in classic_functions as Call::Classic {
        ActiveTexture: glActiveTextureARB(unit: u32)
            => "glActiveTextureARB"(texture = format!("GL_TEXTURE{unit}_ARB"));
        BindTexture: bind_texture(target: TextureTarget, texture: Map)
            => "glBindTexture"(target, texture);
        /// The paper's `simple_1x1_uhilo.bind()`: one texel of GL_UNSIGNED_HILO_NV, both of its numbers 0.
        BindUnsignedHilo: bind_simple_1x1_uhilo() => "simple_1x1_uhilo.bind"();
        Enable: enable_classic(cap: ClassicCapability) => "glEnable"(cap);
        Disable: disable_classic(cap: ClassicCapability) => "glDisable"(cap);
        AlphaFunc: glAlphaFunc(func: Compare, reference: f32)
            => "glAlphaFunc"(func, ref = reference.to_string());
        TexEnv: glTexEnvi(target: TexEnvName, pname: TexEnvName, param: TexEnvValue);
        /// `glCombinerInputNV` for the alpha of the first general combiner. Colours go through as they are.
        CombinerInput: glCombinerInputNV(variable: CombinerVariable, input: CombinerRegister, mapping: CombinerMapping, component: CombinerComponent)
            => "glCombinerInputNV"(stage = "GL_COMBINER0_NV", portion = "GL_ALPHA", variable, input, mapping, componentUsage = component);
        /// `glTexParameteri` with `GL_DEPTH_TEXTURE_MODE`.
        DepthTextureMode: depth_texture_mode(mode: DepthTextureMode)
            => "glTexParameteri"(target = "GL_TEXTURE_2D", pname = "GL_DEPTH_TEXTURE_MODE", param = mode);
        /// `glTexParameteri` with `GL_TEXTURE_COMPARE_MODE`: `GL_COMPARE_R_TO_TEXTURE` or `GL_NONE`.
        TextureCompareMode: compare_r_to_texture(on: bool)
            => "glTexParameteri"(target = "GL_TEXTURE_2D", pname = "GL_TEXTURE_COMPARE_MODE", param = compare_mode(*on));
        /// `glTexParameteri` with `GL_TEXTURE_COMPARE_FUNC`.
        TextureCompareFunc: texture_compare_func(func: Compare)
            => "glTexParameteri"(target = "GL_TEXTURE_2D", pname = "GL_TEXTURE_COMPARE_FUNC", param = func);
        MatrixMode: glMatrixMode(mode: MatrixMode);
        PushMatrix: glPushMatrix();
        PopMatrix: glPopMatrix();
        LoadIdentity: glLoadIdentity();
        Translate: glTranslatef(x: f32, y: f32, z: f32)
            => "glTranslatef"(x = x.to_string(), y = y.to_string(), z = z.to_string());
        Scale: glScalef(x: f32, y: f32, z: f32)
            => "glScalef"(x = x.to_string(), y = y.to_string(), z = z.to_string());
        /// `glScalef` with computed factors for x and y, and 1 for z.
        ScaleBy: scale_by(x: Number<f32>, y: Number<f32>) => "glScalef"(x, y, z = "1");
        /// The paper's `m(0,0) = ...`: sixteen assignments, row by row.
        SetM: m(rows: [[f32; 4]; 4]);
        /// The paper's `glMultMatrix(m)`.
        MultM: glMultMatrix_m() => "glMultMatrix"(m = "m");
        /// The paper's `reshaper.apply_perspective()`: multiplies by the camera's projection.
        ApplyPerspective: apply_perspective() => "reshaper.apply_perspective"();
        /// The paper's `eye_linear_texgen()`: on all four coordinates EYE_LINEAR with the identity's planes.
        EyeLinearTexgen: eye_linear_texgen();
        /// EYE_LINEAR on all four coordinates with these planes, for s, t, r and q.
        EyePlanes: eye_planes(planes: [[f32; 4]; 4]) => "eye_linear_texgen"(planes);
        /// The paper's `texgen(true)`: enables generation of all four coordinates.
        Texgen: texgen(on: bool) => "texgen"(on = on.to_string());
        /// `glCopyTexSubImage2D` of a whole depth buffer into a rectangle texture of its size and format, which is made
        /// if it is missing.
        CopyToRectangle: glCopyTexSubImage2D(from: Map, to: Map)
            => "glCopyTexSubImage2D"(target = TextureTarget::Rectangle, from, to);
    }
}

const fn itself(call: Call) -> Call {
    call
}

/// A mask of bits, as it is printed.
fn bits(mask: u32) -> String {
    format!("0x{mask:02X}")
}

const fn compare_mode(on: bool) -> &'static str {
    if on {
        "GL_COMPARE_R_TO_TEXTURE"
    } else {
        "GL_NONE"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_names_its_resources_and_its_variables() {
        let call = functions::glCopyImageSubData(Map::named("a"), Map::at("layer", "i"));
        let names: Vec<_> = call.names().collect();
        let [a, layer] = [Map::named("a"), Map::at("layer", "i")].map(Name::Map);
        assert_eq!(names, [a, layer, Name::Variable("i")]);
        let classic = classic_functions::bind_texture(TextureTarget::Rectangle, Map::named("a"));
        assert_eq!(classic.names().collect::<Vec<_>>(), [a]);
        assert_eq!(functions::glDepthMask(true).names().count(), 0);
    }

    #[test]
    fn a_resolved_call_has_values_in_the_places_of_its_variables() {
        let call = functions::useProgramOfSize(Shader("resolve"), Number::Variable("n"));
        assert_eq!(call.to_string(), "glUseProgram(program = resolve, N = n)");
        let resolved = call.resolved(&|_| Ok(8.0)).unwrap();
        assert_eq!(
            resolved.to_string(),
            "glUseProgram(program = resolve, N = 8)"
        );
        assert_eq!(resolved.names().count(), 1);
    }

    #[test]
    fn a_number_that_was_not_resolved_is_an_error_that_names_its_variable() {
        let error = Number::<u32>::Variable("n").known().unwrap_err();
        assert!(error.to_string().contains("variable n"), "{error}");
        assert_eq!(Number::Known(3).known().unwrap(), 3);
    }
}
