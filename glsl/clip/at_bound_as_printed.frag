#version 430 core
// What lies at the upper bound, whatever bounds it.

#define INSIDE(z) z == upper_bound()
#include "common/clipped.glsl"
