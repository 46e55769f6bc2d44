// Sectors of ray directions that maps tell apart.
#include "relievo/maps.glsl"

// The sector of rays along `direction`, in texels: the quadrant (du<0) + 2·(dv<0), and of eight the half
// that is steep in the metric + 4.
int reliefSector(vec2 direction, int sectors) {
    if (sectors == 1) return 0;
    int quadrant = int(direction.x < 0.0) + 2 * int(direction.y < 0.0);
    bool isSteep = abs(direction.y) * reliefTexelAspect() > abs(direction.x);
    return quadrant + (sectors == 8 && isSteep ? 4 : 0);
}
