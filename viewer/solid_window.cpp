#include "viewer/solid_window.h"

namespace relievo::viewer {

void runSolidWindow(const ViewOptions&) {}

}  // namespace relievo::viewer
