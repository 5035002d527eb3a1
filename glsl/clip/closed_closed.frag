#version 430 core
// What lies between the bounds or at one of them: [lower, upper].

#define INSIDE(z) lower_bound() <= z && z <= upper_bound()
#include "common/clipped.glsl"
