#version 430 core
// What lies between the bounds or at the lower one: [lower, upper).

#define INSIDE(z) lower_bound() <= z && z < upper_bound()
#include "common/clipped.glsl"
