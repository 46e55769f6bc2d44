// The MIP level that a search looks at: a relief of its own on the same tile, with maps of its own
// (specification 3.5). A search stays in one level, so that what is safe there stays safe.
//
// A technique whose maps have no levels defines RELIEVO_BASE_LEVEL before it includes this.

#if defined(RELIEVO_MIPS) && !defined(RELIEVO_BASE_LEVEL)
int reliefLevel = 0;
void reliefSelectLevel(int level) { reliefLevel = level; }
#else
const int reliefLevel = 0;
void reliefSelectLevel(int level) {}
#endif
