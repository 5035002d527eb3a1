// Fragments of a pixel run one after the other, in the order of submission, between the two ends of an interlock. A main
// function writes the ends itself, because neither may stand anywhere else.
//
// Without the extension the ends are empty. Nothing promises the order then, but llvmpipe, which draws each tile by one
// thread, keeps it.
#extension GL_ARB_fragment_shader_interlock : enable

#ifdef GL_ARB_fragment_shader_interlock
layout(pixel_interlock_ordered) in;
#define BEGIN_INTERLOCK beginInvocationInterlockARB();
#define END_INTERLOCK endInvocationInterlockARB();
#else
#define BEGIN_INTERLOCK
#define END_INTERLOCK
#endif
