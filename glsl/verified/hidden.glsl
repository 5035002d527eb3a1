// What opaque surfaces hide, where the depth test is busy with something else. Scenes without opaque surfaces
// (OPAQUE 0) look nothing up.
// defines: method

#include "common/fragment_depth.glsl"

#if OPAQUE
layout(binding = 5) uniform sampler2D opaque;

#define SKIP_WHAT_IS_HIDDEN \
    if (FRAGMENT_DEPTH >= texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r) { \
        discard; \
    }
#else
#define SKIP_WHAT_IS_HIDDEN
#endif
