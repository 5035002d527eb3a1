// What Algorithm 2 asks of an ideal GPU (Carr et al. 2008, section 7): buffers that a fragment shader reads and writes
// in the order of submission. Here they are the framebuffer's color maps, fetched.
//
// A map that a shader must not change is masked (glColorMaski): drivers do not keep one that is only read.

layout(location = 0) inout vec4 depths;      // z1, z2, z3, zPostFlag
layout(location = 1) inout vec4 image;       // premultiplied, front to back
layout(location = 2) inout vec4 peel;        // zPeel

layout(binding = 4) uniform sampler2D opaque;

float opaque_depth() {
    return texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r;
}

// Where a run ends: at what interrupts it, or at the nearest surface submitted before it.
float tight_bound() {
    return depths.w != 0.0 ? depths.z : depths.y;
}
