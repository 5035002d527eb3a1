#version 430 core
// Carr et al. 2008, section 6: white, and the depth as alpha; in [lower, upper).

#define INSIDE(z) lower_bound() <= z && z < upper_bound()
#define COLOR(z) vec4(1.0, 1.0, 1.0, z)
#include "common/clipped.glsl"
