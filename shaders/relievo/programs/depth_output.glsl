// The window depth of a hit lies behind that of the surface that carries it. To say so keeps the early
// depth test of hardware that has it for such programs.
#ifdef RELIEVO_DEPTH_REVERSED
layout(depth_less) out float gl_FragDepth;
#else
layout(depth_greater) out float gl_FragDepth;
#endif
