#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "textures/map_set.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// Writes a map file: `.exr` (Float, Half; named channels) or `.png`, `.tif`, `.tiff` (U16, U8; up
/// to four channels packed as RGBA, with names and ranges in the metadata). A packed file that
/// holds only channels of the thesis' form has them at R=dx, G=dy, B=cone, A=depth when there are
/// enough of them, other channels keep their order. Values are rounded as storedValues says. The
/// file appears whole or not at all. Throws InputError when the format and the extension do not go
/// together, when there are too many channels for a packed file, when a value cannot be stored
/// (not finite), or when writing fails. The same maps give the same bytes.
void writeMapFile(const std::filesystem::path& file, const MapSet& maps, StorageFormat format);

/// Writes a map file with MIP levels: `levels` are the maps of a relief and of its levels, with the
/// same channels and metadata, each of half the size of the one before, rounded down, to 1×1. The
/// file is tiled. PNG files hold one level; otherwise as above.
void writeMapFile(const std::filesystem::path& file, std::span<const MapSet> levels,
                  StorageFormat format);

/// Throws InputError, beginning with `file`, when a map file of this size would be one that
/// readMapFile refuses. writeMapFile asks it; a caller may do so before the work.
void requireReadableSize(const std::filesystem::path& file, int width, int height,
                         std::size_t channels);

/// Whether the image `file` says that it is a map file: it has an attribute called `relievo:…`.
/// Throws InputError for what is no image.
bool isMapFile(const std::filesystem::path& file);

/// Reads a map file written by writeMapFile, of several levels the first. Throws InputError that
/// names the missing or senseless attribute or channel.
MapSet readMapFile(const std::filesystem::path& file);

/// Reads all levels of a map file: one, or as many as it has down to 1×1, each with its
/// texelAspect. Throws as readMapFile.
std::vector<MapSet> readMapLevels(const std::filesystem::path& file);

/// What a map file says about itself: its metadata without the channels. Throws InputError when it
/// makes no sense, or when the end of the file is missing.
MapSet readMapDescription(const std::filesystem::path& file);

}  // namespace relievo::textures
