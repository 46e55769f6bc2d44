#include "textures/storage_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "textures/channel_coding.h"

namespace relievo::textures {

namespace {

ChannelCoding codingOf(const Plane& values, std::string_view channel, StorageFormat format,
                       ConeEncoding encoding) {
    return channelCoding(std::array{&values}, channel, format, encoding);
}

/// Rows are converted one at a time: the loss of a large map needs no copy of it.
void addLoss(std::span<const float> values, std::span<const float> stored, StorageLoss& loss) {
    for (std::size_t t = 0; t < values.size(); ++t) {
        if (!std::isfinite(values[t]) || !(values[t] > 0.0f))
            continue;
        const double share = static_cast<double>(stored[t]) / values[t];
        ++loss.cones;
        loss.meanShare += share;
        loss.worstShare = std::min(loss.worstShare, share);
        loss.vanishing += stored[t] == 0.0f ? 1 : 0;
        loss.narrowed += values[t] > loss.widest ? 1 : 0;
    }
}

}  // namespace

Plane storedValues(const Plane& values, std::string_view channel, StorageFormat format,
                   ConeEncoding encoding) {
    Plane stored = values;
    storeInPlace(stored, channel, format, encoding);
    return stored;
}

void storeInPlace(Plane& values, std::string_view channel, StorageFormat format,
                  ConeEncoding encoding) {
    const ChannelCoding coding = codingOf(values, channel, format, encoding);
    toSamples(coding, values.texels, values.texels);
    toValues(coding, values.texels);
}

StorageLoss storageLoss(const Plane& values, std::string_view channel, StorageFormat format,
                        ConeEncoding encoding) {
    const ChannelCoding coding = codingOf(values, channel, format, encoding);
    StorageLoss loss;
    loss.meanShare = 0.0;
    loss.widest = kLargestHalf;
    if (isPackedFormat(format)) {
        auto widest = static_cast<float>(maximumCode(format));
        toValues(coding, {&widest, 1});
        loss.widest = widest;
    }
    std::vector<float> stored(static_cast<std::size_t>(values.width));
    for (std::size_t start = 0; start < values.texels.size(); start += stored.size()) {
        const std::span row = std::span(values.texels).subspan(start, stored.size());
        toSamples(coding, row, stored);
        toValues(coding, stored);
        addLoss(row, stored, loss);
    }
    loss.meanShare = loss.cones > 0 ? loss.meanShare / static_cast<double>(loss.cones) : 1.0;
    return loss;
}

}  // namespace relievo::textures
