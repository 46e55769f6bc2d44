#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "preprocess/relief_tree.h"
#include "preprocess/slope_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Conservative cones with the guarantee Bilinear (conservative_cones.h) of a map that may be
/// edited: after an edit only the texels that it can influence are built anew.
///
/// Three passes: the chords from the square of each texel to samples a few texels away, in a window
/// (bilinear_slopes.h); those from the corners of the squares to what lies beyond, by search
/// (slope_search.h); and the nearest ones, where the gradients around do not bound them well
/// enough. Memory: 27 bytes a texel besides map and ratios.
class BilinearCones {
  public:
    /// Builds the cones of `map`. `advance`, when given, is called from any thread with the number
    /// of texels just finished.
    explicit BilinearCones(textures::DepthMap map,
                           const std::function<void(std::size_t)>& advance = {},
                           SlopeSearchStatistics* statistics = nullptr);
    ~BilinearCones();
    BilinearCones(const BilinearCones&) = delete;
    BilinearCones& operator=(const BilinearCones&) = delete;

    [[nodiscard]] const textures::DepthMap& map() const noexcept { return map_; }
    /// Tile widths per unit of depth; +infinity where nothing is higher.
    [[nodiscard]] const textures::Plane& ratio() const& noexcept { return ratio_; }
    [[nodiscard]] textures::Plane ratio() && noexcept { return std::move(ratio_); }

    /// Replaces the depths of the rectangle whose first texel is (left,top) and brings the cones up
    /// to date: bit for bit those of a new build of the edited map. The rectangle must lie in the
    /// map. Returns how many texels were built anew.
    std::size_t edit(int left, int top, const textures::Plane& depths);

  private:
    struct Marks;
    struct Workers;
    void build(Marks& marks, const std::function<void(std::size_t)>& advance);
    void findCoarse(const Marks& marks);
    void findCorners(Marks& marks);
    void refine(const Marks& marks, const std::function<void(std::size_t)>& advance);
    [[nodiscard]] float knownAround(int i, int j) const;
    void markNear(const TexelRectangle& rectangle, Marks& marks) const;
    void markReached(const TexelRectangle& rectangle, float leastDepth, Marks& marks) const;

    textures::DepthMap map_;
    ReliefTree tree_;
    textures::Plane coarse_;       // slopes of the first pass
    textures::Plane cornerDepth_;  // (i,j): the corner at (i−½, j−½)
    textures::Plane corner_;       // slopes of the second pass
    textures::Plane ratio_;
    std::unique_ptr<Workers> workers_;  // kept: setting them up takes longer than a small edit
};

}  // namespace relievo::preprocess
