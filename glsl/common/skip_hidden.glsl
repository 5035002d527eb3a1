// What an opaque surface hides leaves no trace in buffers and images. The depth test comes before the shader, and so before
// what it writes; but not where the shader itself says what is tested.

#include "common/fragment_depth.glsl"

#ifdef INVERSE_W
layout(binding = 5) uniform sampler2D opaque;

#define SKIP_HIDDEN if (FRAGMENT_DEPTH >= texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r) { discard; }
#else
layout(early_fragment_tests) in;

#define SKIP_HIDDEN
#endif
