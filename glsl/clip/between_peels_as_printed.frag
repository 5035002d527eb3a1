#version 430 core
// Sorted surfaces between two peels: (lower, upper); line 17 of Algorithm 1.

#define INSIDE(z) lower_bound() < z && z < upper_bound()
#include "common/clipped.glsl"
