#version 430 core
// Equation 6 of McGuire and Bavoil (2013): the weighted mean of the colours. Alpha is the transmittance of all fragments
// together. In a pixel without a fragment it is 1, and the mean is taken to be 0.
// vertex: screen.vert

layout(binding = 2) uniform sampler2D accumulated;
layout(binding = 3) uniform sampler2D revealage;

out vec4 color;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 sums = texelFetch(accumulated, here, 0);
    vec3 mean = sums.a > 0.0 ? sums.rgb / sums.a : vec3(0.0);
    color = vec4(mean, texelFetch(revealage, here, 0).r);
}
