#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "textures/channel_coding.h"
#include "textures/map_set.h"

namespace relievo::textures {

/// The text attributes of a map file, by full name.
using TextAttributes = std::map<std::string, std::string>;

/// The name in `relievo:channels` of a stored channel that holds nothing.
inline constexpr std::string_view kUnusedChannel = "-";

/// The ranges of packed channels by name.
using ChannelRanges = std::map<std::string, ChannelRange>;

/// The attributes that describe `maps`: its metadata, the stored channels in the order of `layout`
/// (kUnusedChannel for one that holds nothing), and in a packed file their `ranges`, written as
/// `dx=-3.5:3.25 depth=0:1` with as many digits as bring the number back. Throws
/// std::invalid_argument for an attribute of `maps` that is not called `relievo:…` or takes the
/// place of one written here.
TextAttributes describeMaps(const MapSet& maps, const std::vector<std::string>& layout,
                            const ChannelRanges& ranges);

/// A map set without channels, as `attributes` describe it. Throws InputError, beginning with
/// `file`, that names the attribute which is missing or makes no sense.
MapSet mapsFromAttributes(const TextAttributes& attributes, const std::string& file);

/// The names in `relievo:channels`. Throws InputError when it is missing, empty, or names a channel
/// twice.
std::vector<std::string> layoutFromAttributes(const TextAttributes& attributes,
                                              const std::string& file);

/// The ranges in `relievo:scale`. Throws InputError when it is missing or cannot be understood.
ChannelRanges rangesFromAttributes(const TextAttributes& attributes, const std::string& file);

}  // namespace relievo::textures
