#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "reference/guarantee_check.h"
#include "reference/roof_map.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The command line of `relievo-bake verify`, as words. The ones after `json` are for files of
/// other tools, which do not say these things themselves; "" and nothing mean not given.
struct VerifyArguments {
    std::string file;
    double rays = 1e6;  ///< a whole number; double, so that 1e7 can be written
    std::uint64_t seed = 1;
    bool json = false;

    std::string depthFile;
    std::string depthChannel;
    std::string coneChannel;
    std::string roofChannel;
    std::string kind;
    std::string encoding;
    std::string wrap;
    std::string input;
    std::optional<double> coneScale;
};

/// Conservative or relaxed cones with their apexes on the surface.
struct SurfaceCones {
    std::vector<textures::Plane> ratios;  ///< tile widths per unit of depth, of 1, 4 or 8 sectors
    reference::ConePromise promise = reference::ConePromise::Conservative;
};

/// A map to check, over the relief it is for.
struct ConesToVerify {
    std::string description;  ///< "conservative cones"
    textures::DepthMap relief;
    std::variant<SurfaceCones, reference::RoofMap> cones;
};

/// Throws UsageError when an option is given that is for files of other tools: a map file says
/// itself what these options say, and to have them contradict it helps nobody.
void refuseOptionsOfOtherTools(const VerifyArguments& arguments);

/// The maps with a promise in a map file, or in an image of another tool as the arguments describe
/// it. Throws InputError for a file that cannot be read, holds no cones or values that cannot be
/// cones, and UsageError for options that do not go with the file.
std::vector<ConesToVerify> readConesToVerify(const VerifyArguments& arguments);

}  // namespace relievo::preprocess
