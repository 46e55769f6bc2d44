#include "solids/profile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "textures/input_error.h"

namespace relievo::solids {
namespace {

constexpr std::array kAllShapes{ProfileShape::Bevel, ProfileShape::Round, ProfileShape::Cove,
                                ProfileShape::Ogee};

TEST(Profile, BeginsAtTheExtensionAndEndsAtTheBevel) {
    for (const ProfileShape shape : kAllShapes)
        for (const double bevel : {0.2, -0.1}) {
            const Profile profile = makeProfile(0.05, bevel, 0.4, shape);
            EXPECT_NEAR(offsetAt(profile, 0.0), 0.05, 1e-15) << profileShapeName(shape);
            EXPECT_NEAR(offsetAt(profile, 0.4), 0.05 + bevel, 1e-15);
            EXPECT_NEAR(offsetAt(profile, 1.0), 0.05 + bevel, 1e-15);
        }
}

TEST(Profile, PiecesFollowEachOtherWithoutGaps) {
    for (const ProfileShape shape : kAllShapes)
        for (const double chamfer : {1.0, 0.3}) {
            const Profile profile = makeProfile(0.0, 0.1, chamfer, shape);
            ASSERT_LE(profile.pieces.size(), static_cast<std::size_t>(kMostPieces));
            EXPECT_EQ(profile.pieces.front().top, 0.0);
            EXPECT_EQ(profile.pieces.back().bottom, 1.0);
            for (std::size_t k = 0; k + 1 < profile.pieces.size(); ++k) {
                EXPECT_EQ(profile.pieces[k].bottom, profile.pieces[k + 1].top);
                EXPECT_LT(profile.pieces[k].top, profile.pieces[k].bottom);
                EXPECT_NEAR(profile.pieces[k].bottomOffset, profile.pieces[k + 1].topOffset, 1e-15);
            }
        }
}

TEST(Profile, RoundOnesAreNearTheirClosedForms) {
    const double bevel = 0.2;
    const double depth = 0.5;
    const Profile round = makeProfile(0.1, bevel, depth, ProfileShape::Round);
    const Profile cove = makeProfile(0.1, bevel, depth, ProfileShape::Cove);
    for (int k = 0; k <= 1000; ++k) {
        const double x = k / 1000.0;
        // Along the curve of a unit circle the chords deviate by 1 − cos(π/48); measured along the
        // offset alone it is more where the curve is level. Seen from the centre of the circle:
        const double o = (offsetAt(round, depth * x) - 0.1) / bevel;
        EXPECT_LE(std::hypot(1.0 - x, o), 1.0 + 1e-12);
        EXPECT_GE(std::hypot(1.0 - x, o), std::cos(std::acos(-1.0) / 48.0) - 1e-12);
        const double hollow = 1.0 - (offsetAt(cove, depth * x) - 0.1) / bevel;
        EXPECT_LE(std::hypot(x, hollow), 1.0 + 1e-12);
        EXPECT_GE(std::hypot(x, hollow), std::cos(std::acos(-1.0) / 48.0) - 1e-12);
    }
}

TEST(Profile, NormalsAreThoseOfTheRoundCurve) {
    const Profile round = makeProfile(0.0, 0.2, 0.5, ProfileShape::Round);
    for (const ProfilePiece& piece : round.pieces) {
        if (piece.top >= 0.5)
            continue;
        const double x = piece.top / 0.5;  // o = b·√(1 − (1−x)²)
        const double derivative = 0.2 / 0.5 * (1.0 - x) / std::sqrt(1.0 - (1.0 - x) * (1.0 - x));
        if (piece.top > 0.0) {
            EXPECT_NEAR(piece.topNormal.y / piece.topNormal.x, derivative, 1e-9);
        }
    }
    EXPECT_NEAR(round.pieces.front().topNormal.x, 0.0, 1e-15);
    EXPECT_GT(round.pieces.front().topNormal.y, 0.0);
}

TEST(Profile, KnotsMayMakeSteps) {
    const std::array<glm::dvec2, 4> knots{{{0.2, 0.1}, {0.5, 0.1}, {0.5, 0.3}, {0.75, 0.0}}};
    const Profile profile = profileThrough(knots);
    EXPECT_EQ(profile.pieces.size(), 4u);
    EXPECT_NEAR(offsetAt(profile, 0.0), 0.1, 1e-15);
    EXPECT_NEAR(offsetAt(profile, 0.49), 0.1, 1e-15);
    EXPECT_NEAR(offsetAt(profile, 0.5), 0.3, 1e-15);
    EXPECT_NEAR(offsetAt(profile, 1.0), 0.0, 1e-15);
    EXPECT_NEAR(largestOffset(profile), 0.3, 1e-15);
}

TEST(Profile, RefusesSenselessKnots) {
    const std::array<glm::dvec2, 2> backwards{{{0.5, 0.1}, {0.2, 0.1}}};
    const std::array<glm::dvec2, 1> outside{{{1.5, 0.1}}};
    const std::array<glm::dvec2, 1> infinite{{{0.5, INFINITY}}};
    EXPECT_THROW(profileThrough({}), textures::InputError);
    EXPECT_THROW(profileThrough(backwards), textures::InputError);
    EXPECT_THROW(profileThrough(outside), textures::InputError);
    EXPECT_THROW(profileThrough(infinite), textures::InputError);
    const std::vector<glm::dvec2> many(100, {0.5, 0.1});
    EXPECT_EQ(profileThrough(many).pieces.size(), 2u);
    std::vector<glm::dvec2> steps;
    for (int k = 0; k < 40; ++k)
        steps.push_back({k / 40.0, 0.1});
    EXPECT_THROW(profileThrough(steps), textures::InputError);
}

}  // namespace
}  // namespace relievo::solids
