// The depth that a surface's fragment is tested, stored and compared with.
//
// With INVERSE_W it is 1/w, which is exact to a part of itself where window-space depths crowd together at 1. near / w
// falls from 1 at the near plane, and depth tests ask for what is less; so its bits are counted down. That turns the order
// of floats round and keeps them apart: the smallest normal float, which is next to 0, lies at the near plane, 1 infinitely
// far away, and no line of a listing has to change. Below the smallest normal float no depth may lie, for llvmpipe and most
// GPUs take what is smaller for 0.
//
// Macros, because a program's files may each include this, and a function would have several bodies.

#ifdef INVERSE_W
#define NEAR_OVER_W min(uintBitsToFloat(uint(INVERSE_W)) * gl_FragCoord.w, 1.0)
#define FRAGMENT_DEPTH uintBitsToFloat(floatBitsToUint(1.0) + 0x00800000u - floatBitsToUint(NEAR_OVER_W))
#define STORE_DEPTH gl_FragDepth = FRAGMENT_DEPTH;
#else
#define FRAGMENT_DEPTH gl_FragCoord.z
#define STORE_DEPTH
#endif
