#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/relief_plan.h"
#include "textures/depth_map.h"
#include "textures/map_set.h"

namespace relievo::preprocess {

/// Who wants to know how far bakeRelief is. Each may be empty.
struct BakeObserver {
    /// A map is begun: its name and the texels that it has.
    std::function<void(std::string_view map, std::size_t texels)> begin;
    /// Called from any thread with the number of texels just finished.
    std::function<void(std::size_t texels)> advance;
    /// The map is done; what its builder has to say about the work.
    std::function<void(std::string_view map, const std::string& counts)> end;
};

/// What makes `plan` impossible, as a sentence that names the option of `relievo-bake relief`; ""
/// when it can be baked.
std::string planProblem(const ReliefPlan& plan);

/// All of `plan` that changes the maps, as words that are the same for plans that mean the same:
/// the attribute `relievo:options`.
std::string optionWords(const ReliefPlan& plan);

/// The maps of a relief that `plan` asks for, ready for textures::writeMapFile with the plan's
/// format. All belong to the depths as that format stores them, not to those before rounding.
/// Throws std::invalid_argument when planProblem has something to say. The same for any number of
/// threads.
textures::MapSet bakeRelief(textures::DepthMap relief, const ReliefPlan& plan,
                            const BakeObserver& observer = {});

/// bakeRelief for the relief and, when the plan has mips, for each of its MIP levels: a level is a
/// relief of its own, of filtered depths, with maps of its own, because maps such as cones cannot
/// be filtered (specification 3.5). Progress is told of the first level, which is most of the work.
std::vector<textures::MapSet> bakeLevels(textures::DepthMap relief, const ReliefPlan& plan,
                                         const BakeObserver& observer = {});

}  // namespace relievo::preprocess
