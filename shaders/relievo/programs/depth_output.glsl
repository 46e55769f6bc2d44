// The window depth of a hit lies behind that of the surface that carries it, and in front of the back faces of
// a box around it. To say so keeps the early depth test of hardware that has it for such programs.
#if defined(RELIEVO_DEPTH_REVERSED) != defined(RELIEVO_SHAPE_BOX)
layout(depth_less) out float gl_FragDepth;
#else
layout(depth_greater) out float gl_FragDepth;
#endif
