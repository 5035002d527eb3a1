// A peeled layer. It is where its depth lies before the opaque depth, from which every peel starts; elsewhere the
// pixel is discarded, so that an occlusion query counts the layer's pixels.

layout(binding = 1) uniform sampler2D opaque_depth;
layout(binding = 2) uniform sampler2D layer_color;
layout(binding = 3) uniform sampler2D layer_depth;

vec4 layer() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    if (texelFetch(layer_depth, here, 0).r >= texelFetch(opaque_depth, here, 0).r) {
        discard;
    }
    return texelFetch(layer_color, here, 0);
}
