// The fragment record (Lindholm et al. 2015, section 6.1): z (float32), id (int32), color (vec4 float16), 16 bytes.
// defines: method

#include "a_buffer/id.glsl"

// Depth and colour as they are kept. With FLOAT_COLOR the colour takes a second word of 16 bytes. With FIXED_COLOR it has 24
// bits a channel, and takes the place of the id, too: alpha's bytes are the highest of the three words.
#if FLOAT_COLOR
const uint WORDS = 2u;
#else
const uint WORDS = 1u;
#endif

const float LARGEST = 16777215.0;    // 24 bits

uvec4 head_of(float z, uint id, vec4 color) {
#if FLOAT_COLOR
    return uvec4(floatBitsToUint(z), id, 0u, 0u);
#elif FIXED_COLOR
    // Interpolation may round to a little more than 1.
    uvec4 fixed_color = uvec4(roundEven(clamp(color, 0.0, 1.0) * LARGEST));
    uvec3 alpha = fixed_color.aaa >> uvec3(0u, 8u, 16u) & 0xFFu;
    return uvec4(floatBitsToUint(z), fixed_color.rgb | alpha << 24);
#else
    return uvec4(floatBitsToUint(z), id, packHalf2x16(color.rg), packHalf2x16(color.ba));
#endif
}
