#include "materials/profile_bounds.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace relievo::materials {
namespace {

using solids::Profile;
using solids::ProfileShape;

// Offsets of both sides of every knot and of places in between, along the way of a ray.
struct Place {
    double along;  // grows on the way
    double offset;
    std::size_t piece;
};

std::vector<Place> placesOf(const Profile& profile, bool isUp, bool isInside) {
    std::vector<Place> places;
    constexpr int kPerPiece = 16;
    const double sense = isInside ? -1.0 : 1.0;
    for (std::size_t k = 0; k < profile.pieces.size(); ++k)
        for (int i = 0; i <= kPerPiece; ++i) {
            const solids::ProfilePiece& piece = profile.pieces[k];
            const double z = std::lerp(piece.top, piece.bottom, static_cast<double>(i) / kPerPiece);
            places.push_back({isUp ? -z : z, sense * piece.offset(z), k});
        }
    if (isUp)
        std::ranges::reverse(places);
    return places;
}

// How often the bounds, with chords times `factor`, are passed.
int violations(const Profile& profile, double factor) {
    constexpr double kRounding = 1e-9;
    const std::vector<ProfileBounds> bounds = profileBounds(profile);
    int count = 0;
    for (std::size_t way = 0; way < kProfileWays; ++way) {
        const bool isUp = way % 2 == 1;
        const std::vector<Place> places = placesOf(profile, isUp, way >= 2);
        for (std::size_t from = 0; from < places.size(); ++from) {
            const ProfileBounds& piece = bounds[places[from].piece];
            const double limit = isUp ? -piece.limit[way] : piece.limit[way];
            for (std::size_t to = from; to < places.size(); ++to) {
                const double way1 = places[to].along - places[from].along;
                count += places[to].offset > piece.extreme[way] + kRounding;
                if (places[to].along < limit - kRounding)
                    count += places[to].offset >
                             places[from].offset + factor * piece.chord[way] * way1 + kRounding;
            }
        }
    }
    return count;
}

Profile randomTable(std::mt19937_64& random) {
    std::uniform_real_distribution<double> offsets(-0.3, 0.3);
    std::uniform_int_distribution<int> knots(1, 12);
    std::uniform_int_distribution<int> depths(0, 10);
    std::vector<glm::dvec2> table;
    for (int k = knots(random); k > 0; --k)
        table.push_back({depths(random) / 10.0, offsets(random)});
    std::ranges::sort(table, {}, [](const glm::dvec2& knot) { return knot.x; });
    return solids::profileThrough(table);
}

TEST(ProfileBounds, HoldForEveryShapeOfProfile) {
    for (const ProfileShape shape :
         {ProfileShape::Bevel, ProfileShape::Round, ProfileShape::Cove, ProfileShape::Ogee})
        for (const double bevel : {0.2, -0.1, 0.0})
            for (const double chamfer : {1.0, 0.3})
                EXPECT_EQ(violations(solids::makeProfile(0.05, bevel, chamfer, shape), 1.0), 0)
                    << solids::profileShapeName(shape) << " " << bevel << " " << chamfer;
}

TEST(ProfileBounds, HoldForTablesWithSteps) {
    std::mt19937_64 random(7);
    for (int k = 0; k < 200; ++k)
        EXPECT_EQ(violations(randomTable(random), 1.0), 0);
}

TEST(ProfileBounds, AreNotWiderThanNeeded) {
    // Chords a hundredth flatter are passed somewhere by every profile that is not straight up.
    for (const ProfileShape shape : {ProfileShape::Bevel, ProfileShape::Round, ProfileShape::Ogee})
        EXPECT_GT(violations(solids::makeProfile(0.0, 0.2, 0.5, shape), 0.99), 0);
}

TEST(ProfileBounds, StepsAreLimitsOfTheSideThatTheyComeNearerTo) {
    const std::array<glm::dvec2, 4> knots{{{0.0, 0.1}, {0.5, 0.1}, {0.5, 0.3}, {1.0, 0.3}}};
    const std::vector<ProfileBounds> bounds = profileBounds(solids::profileThrough(knots));
    ASSERT_EQ(bounds.size(), 2u);
    EXPECT_EQ(bounds[0].limit[0], 0.5);   // down from outside: the solid gets wider
    EXPECT_EQ(bounds[1].limit[1], -1.0);  // up from outside: narrower
    EXPECT_EQ(bounds[0].limit[2], 2.0);   // down from inside: the outside goes farther away
    EXPECT_EQ(bounds[1].limit[3], 0.5);   // up from inside: it comes nearer
}

}  // namespace
}  // namespace relievo::materials
