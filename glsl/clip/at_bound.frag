#version 430 core
// What lies at the upper bound, unless that is the opaque depth.

#define INSIDE(z) z == upper_bound() && z < opaque_depth()
#include "common/clipped.glsl"
