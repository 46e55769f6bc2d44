#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/map_kinds.h"

namespace relievo::preprocess {

/// One way to build cones: what they are, what they are safe for, and by which method. Adding one
/// is an entry in cone_kinds.cpp.
struct ConeKind {
    std::string_view cone;         ///< the word of `--cone`
    std::string_view guarantee;    ///< of `--guarantee`
    std::string_view method;       ///< of `--method`
    bool isOnSurface;              ///< channels `cone`…, ratios over the surface, or radii
    std::span<const int> sectors;  ///< that `--sectors` may ask for, the usual number first
    double workingBytes;           ///< as in MapKind
    /// As in MapKind.
    std::vector<std::string> (*channels)(const ReliefPlan& plan);
    std::string (*build)(const MapRequest& request, textures::MapSet& maps);
};

/// All of them. Where a plan leaves guarantee or method open, the first that fits the rest counts.
std::span<const ConeKind> coneKinds();

/// The one that `plan` asks for, or null when there is none.
const ConeKind* findConeKind(const ReliefPlan& plan);

/// How a map file holds the cones of `plan`, which findConeKind must have: as the plan says, else
/// radii for cones on the surface and ratios for cones on a roof, which have no radius.
textures::ConeEncoding coneEncoding(const ReliefPlan& plan);

/// How many sectors of ray directions have cones of their own in the cones of `plan`, which
/// findConeKind must have: as the plan says, else the usual number of the kind, in a packed file,
/// which has few channels, 1 for cones on the surface.
int coneSectors(const ReliefPlan& plan);

/// The kind of cones where none is asked for: the first of roof, conservative and relaxed that the
/// rest of `plan` allows. A packed file has too few channels for roof cones.
std::string usualCone(ReliefPlan plan);

/// The words of all kinds in one of the three respects, each once.
std::vector<std::string> coneWords(std::string_view ConeKind::*respect);

}  // namespace relievo::preprocess
