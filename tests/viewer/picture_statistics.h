#pragma once

#include "viewer/picture.h"

namespace relievo::tests {

/// A part of a picture, in pixels from its upper left.
struct PictureRegion {
    int x;
    int y;
    int width;
    int height;
};

/// The part as a picture of its own; it must lie within.
viewer::Picture crop(const viewer::Picture& picture, const PictureRegion& region);

/// The standard deviation of the grey values: 0 for a blank picture.
double contrast(const viewer::Picture& picture);

/// The correlation coefficient of the grey values of two pictures of one size, in [−1,1]; 0 when
/// one of them is blank.
double correlation(const viewer::Picture& a, const viewer::Picture& b);

}  // namespace relievo::tests
