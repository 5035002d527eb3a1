// What Algorithm 2 asks of an ideal GPU (Carr et al. 2008, section 7): buffers that a fragment shader reads and writes
// in the order of submission.
//
// By default they are the framebuffer's color maps, fetched. A map that a shader must not change is masked
// (glColorMaski): drivers do not keep one that is only read. With IMAGES they are images, loaded and stored between
// the two ends of an interlock: a main function writes BEGIN_FRAGMENT and END_FRAGMENT around what it does.
// defines: method

#if IMAGES
#include "common/interlock.glsl"
#else
#extension GL_EXT_shader_framebuffer_fetch : require
#endif

#if IMAGES
layout(binding = 0, rgba32f) coherent uniform image2D depths_image;
layout(binding = 1, rgba32f) coherent uniform image2D image_image;
layout(binding = 2, rgba32f) coherent uniform image2D peel_image;

vec4 depths;     // z1, z2, z3, zPostFlag
vec4 image;      // premultiplied, front to back
vec4 peel;       // zPeel

void load_pixel() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    depths = imageLoad(depths_image, here);
    image = imageLoad(image_image, here);
    peel = imageLoad(peel_image, here);
}

void store_pixel() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    imageStore(depths_image, here, depths);
    imageStore(image_image, here, image);
    imageStore(peel_image, here, peel);
}

#define BEGIN_FRAGMENT BEGIN_INTERLOCK load_pixel();
#define END_FRAGMENT store_pixel(); END_INTERLOCK
#define READ_FRAGMENT load_pixel();

#else
layout(location = 0) inout vec4 depths;      // z1, z2, z3, zPostFlag
layout(location = 1) inout vec4 image;       // premultiplied, front to back
layout(location = 2) inout vec4 peel;        // zPeel

#define BEGIN_FRAGMENT
#define END_FRAGMENT
#define READ_FRAGMENT
#endif

layout(binding = 4) uniform sampler2D opaque;

float opaque_depth() {
    return texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r;
}

// Where a run ends: at what interrupts it, or at the nearest surface submitted before it.
float tight_bound() {
    return depths.w != 0.0 ? depths.z : depths.y;
}
