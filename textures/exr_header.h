#pragma once

#include <filesystem>
#include <string>

namespace relievo::textures {

/// What is wrong with the header of an EXR file, as the end of a sentence; "" when nothing is, or
/// when it is no EXR file. The library believes sizes in the header and takes memory for them (up
/// to 2 GB for one attribute) before anybody can ask what they are. Refused are attributes longer
/// than the file or of another length than their type has, windows of more than `largestSide`
/// texels a side, tiles of more than 16 Mi texels, and more chunks than the file has bytes.
std::string exrHeaderProblem(const std::filesystem::path& file, int largestSide);

}  // namespace relievo::textures
