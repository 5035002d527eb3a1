// A layer under those before it, premultiplied, for (ONE_MINUS_DST_ALPHA, ONE). Its pixels are alive: there the next
// peel's depth starts from the opaque depth. Elsewhere it stays 0, before which nothing lies.

#include "common/layer.glsl"

out vec4 color;

void under() {
    vec4 straight = layer();
    gl_FragDepth = texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r;
    color = vec4(straight.rgb * straight.a, straight.a);
}
