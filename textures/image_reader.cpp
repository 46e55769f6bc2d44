#include "textures/image_reader.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>

#include "textures/exr_header.h"
#include "textures/input_error.h"
#include "textures/truncation.h"

namespace relievo::textures {

namespace {

constexpr int kLargestSide = 32768;
/// As many as the formats compress together, at most.
constexpr int kRowsAtOnce = 256;
constexpr double kMebibyte = 1024.0 * 1024.0;

[[noreturn]] void reject(const std::filesystem::path& file, std::string_view what) {
    throw InputError(fmt::format("{}: {}", file.string(), what));
}

/// OpenImageIO's last message, as the end of a sentence on one line.
std::string reason(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "no reason given" : message;
}

/// Why opening failed, in brackets; nothing when no format reader recognised the file.
std::string openingFailure() {
    const std::string message = reason(OIIO::geterror());
    return message.starts_with("OpenImageIO could not find") ? "" : fmt::format(" ({})", message);
}

void checkRegularFile(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        const bool missing = status.type() == std::filesystem::file_type::not_found;
        reject(file, missing ? "no such file, expected an image"
                             : fmt::format("cannot be opened: {}", error.message()));
    }
    if (std::filesystem::is_directory(status))
        reject(file, "is a folder, expected an image file");
    if (!std::filesystem::is_regular_file(status))
        reject(file, "is no regular file, expected an image file");
    if (std::filesystem::file_size(file, error) == 0)
        reject(file, "is empty (0 bytes), expected an image");
    if (isTruncatedImage(file))
        reject(file, "is truncated, expected a whole image");
    if (const std::string problem = exrHeaderProblem(file, kLargestSide); !problem.empty())
        reject(file, problem);
    if (isPngOfNoSize(file))
        reject(file, "has a width or height of 0, expected at least one texel");
}

void checkShape(const std::filesystem::path& file, const OIIO::ImageSpec& spec, double largest) {
    if (spec.deep || spec.depth > 1)
        reject(file, "is a deep or volume image, expected a flat one");
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        reject(file,
               fmt::format("is {} x {} texels with {} channels, expected at least one of each",
                           spec.width, spec.height, spec.nchannels));
    if (spec.width > kLargestSide || spec.height > kLargestSide)
        reject(file, fmt::format("is {} x {} texels, expected at most {} per side", spec.width,
                                 spec.height, kLargestSide));
    const double bytes = 1.0 * spec.width * spec.height * spec.nchannels * sizeof(float);
    if (bytes > largest)
        reject(file, fmt::format("takes {:.0f} MiB when decoded ({} x {} texels, {} channels), "
                                 "expected at most {:.0f} MiB",
                                 bytes / kMebibyte, spec.width, spec.height, spec.nchannels,
                                 largest / kMebibyte));
    if (spec.full_width != spec.width || spec.full_height != spec.height)
        reject(file, fmt::format("holds {} x {} texels of a picture of {} x {}, expected all of it",
                                 spec.width, spec.height, spec.full_width, spec.full_height));
}

SampleType sampleTypeOf(const OIIO::TypeDesc& format) {
    if (format == OIIO::TypeDesc::UINT8)
        return SampleType::U8;
    if (format == OIIO::TypeDesc::UINT16)
        return SampleType::U16;
    if (format == OIIO::TypeDesc::HALF)
        return SampleType::Half;
    return format == OIIO::TypeDesc::FLOAT ? SampleType::Float : SampleType::Other;
}

ImageInfo describe(const OIIO::ImageSpec& spec) {
    ImageInfo info;
    info.width = spec.width;
    info.height = spec.height;
    info.type = sampleTypeOf(spec.format);
    info.channelNames = spec.channelnames;
    info.channelNames.resize(static_cast<std::size_t>(spec.nchannels));
    info.orientation = spec.get_int_attribute("Orientation", 1);
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            info.attributes[attribute.name().string()] = attribute.get_string();
    return info;
}

/// Where OpenImageIO has level `level` of an image: EXR has MIP levels, TIFF further pictures.
struct LevelPlace {
    int subimage = 0;
    int mip = 0;
};

LevelPlace placeOf(const OIIO::ImageInput& image, int level) {
    return std::string_view(image.format_name()) == "tiff" ? LevelPlace{level, 0}
                                                           : LevelPlace{0, level};
}

bool seekLevel(OIIO::ImageInput& image, int level) {
    const auto [subimage, mip] = placeOf(image, level);
    return image.seek_subimage(subimage, mip);
}

/// The sizes of all levels, each half of the one before: what has another size is no level of it.
std::vector<LevelSize> levelSizes(OIIO::ImageInput& image) {
    std::vector<LevelSize> sizes{{image.spec().width, image.spec().height}};
    if (image.spec().tile_width == 0)  // levels are tiled
        return sizes;
    for (int level = 1; seekLevel(image, level); ++level) {
        const OIIO::ImageSpec& spec = image.spec();
        const LevelSize half{std::max(sizes.back().width / 2, 1),
                             std::max(sizes.back().height / 2, 1)};
        const bool isLast = sizes.back().width == 1 && sizes.back().height == 1;
        if (isLast || spec.width != half.width || spec.height != half.height)
            break;
        sizes.push_back(half);
    }
    image.seek_subimage(0, 0);
    image.geterror();  // that there are no more levels is no error
    return sizes;
}

}  // namespace

struct ImageReader::Input {
    std::unique_ptr<OIIO::ImageInput> image;

    /// Rows first to end−1 of some channels, interleaved. The TIFF reader fills strips that the
    /// file lacks with zeros, and has a message but returns true.
    template <class Sample>
    bool readRows(int level, int firstRow, int endRow, int firstChannel, int channels,
                  OIIO::TypeDesc type, std::vector<Sample>& samples) const {
        const auto [subimage, mip] = placeOf(*image, level);
        const OIIO::ImageSpec spec = image->spec_dimensions(subimage, mip);
        samples.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels) *
                       static_cast<std::size_t>(endRow - firstRow));
        const int end = firstChannel + channels;
        const bool good =
            spec.tile_width > 0
                ? image->read_tiles(subimage, mip, spec.x, spec.x + spec.width, spec.y + firstRow,
                                    spec.y + endRow, spec.z, spec.z + 1, firstChannel, end, type,
                                    samples.data())
                : image->read_scanlines(subimage, mip, spec.y + firstRow, spec.y + endRow, spec.z,
                                        firstChannel, end, type, samples.data());
        return good && !image->has_error();
    }

    /// Integers are divided by `maximum` here, once and in double: OpenImageIO multiplies by a
    /// rounded inverse. The planes grow with what is read: a header alone gets no memory.
    template <class Sample>
    bool read(int level, int first, std::vector<Plane>& planes, OIIO::TypeDesc type,
              double maximum) const {
        const auto [subimage, mip] = placeOf(*image, level);
        const OIIO::ImageSpec spec = image->spec_dimensions(subimage, mip);
        const std::size_t channels = planes.size();
        const int rowsAtOnce = spec.tile_width > 0 ? spec.tile_height : kRowsAtOnce;
        std::vector<Sample> samples;
        for (int row = 0; row < spec.height; row += rowsAtOnce) {
            const int end = std::min(row + rowsAtOnce, spec.height);
            if (!readRows(level, row, end, first, static_cast<int>(channels), type, samples))
                return false;
            for (std::size_t c = 0; c < channels; ++c)
                for (std::size_t k = c; k < samples.size(); k += channels)
                    planes[c].texels.push_back(static_cast<float>(samples[k] / maximum));
        }
        return true;
    }
};

ImageReader::ImageReader(std::filesystem::path file, double largest) : file_(std::move(file)) {
    checkRegularFile(file_);
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    input_ = std::make_unique<Input>();
    input_->image = OIIO::ImageInput::open(file_.string(), &hints);
    if (!input_->image)
        reject(file_,
               fmt::format("is not an image that can be read{}, expected PNG, TIFF, EXR, JPEG "
                           "or the like",
                           openingFailure()));
    const OIIO::ImageSpec& spec = input_->image->spec();
    checkShape(file_, spec, largest);
    info_ = describe(spec);
    info_.levels = levelSizes(*input_->image);
}

ImageReader::~ImageReader() = default;

int ImageReader::channelIndex(const std::string& nameOrNumber) const {
    const std::vector<std::string>& names = info_.channelNames;
    if (const auto named = std::find(names.begin(), names.end(), nameOrNumber);
        named != names.end())
        return static_cast<int>(named - names.begin());
    int number = -1;
    const char* const end = nameOrNumber.data() + nameOrNumber.size();
    const auto [stop, error] = std::from_chars(nameOrNumber.data(), end, number);
    if (error != std::errc() || stop != end || number < 0 ||
        number >= static_cast<int>(names.size()))
        reject(file_, fmt::format("has no channel '{}', expected one of {} (or 0 to {})",
                                  nameOrNumber, fmt::join(names, ", "), names.size() - 1));
    return number;
}

std::vector<Plane> ImageReader::readChannels(int first, int count, std::size_t level) {
    assert(first >= 0 && count >= 1 &&
           first + count <= static_cast<int>(info_.channelNames.size()));
    std::vector<Plane> planes(static_cast<std::size_t>(count));
    const LevelSize size = info_.levels.at(level);
    for (Plane& plane : planes) {
        plane.width = size.width;
        plane.height = size.height;
        plane.texels.reserve(static_cast<std::size_t>(size.width) *
                             static_cast<std::size_t>(size.height));
    }
    const int mip = static_cast<int>(level);
    bool good = false;
    if (info_.type == SampleType::U8)
        good = input_->read<std::uint8_t>(mip, first, planes, OIIO::TypeDesc::UINT8, 255.0);
    else if (info_.type == SampleType::U16)
        good = input_->read<std::uint16_t>(mip, first, planes, OIIO::TypeDesc::UINT16, 65535.0);
    else
        good = input_->read<float>(mip, first, planes, OIIO::TypeDesc::FLOAT, 1.0);
    if (!good)
        rejectDamaged();
    return planes;
}

void ImageReader::requireEnd() {
    const int height = info_.levels.back().height;
    std::vector<float> samples;
    const OIIO::ImageSpec spec = input_->image->spec();
    const int rows = spec.tile_width > 0 ? spec.tile_height : 1;
    if (!input_->readRows(static_cast<int>(info_.levels.size()) - 1, (height - 1) / rows * rows,
                          height, 0, static_cast<int>(info_.channelNames.size()),
                          OIIO::TypeDesc::FLOAT, samples))
        rejectDamaged();
}

void ImageReader::rejectDamaged() {
    reject(file_, fmt::format("is truncated or damaged ({}), expected a whole image",
                              reason(input_->image->geterror())));
}

}  // namespace relievo::textures
