#include "textures/image_writer.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <utility>

#include "textures/atomic_file.h"
#include "textures/file_extension.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"

namespace relievo::textures {

namespace {

/// EXR and TIFF files carry a date: a fixed one, because the same maps must give the same bytes.
constexpr const char* kFixedDate = "2000:01:01 00:00:00";

/// A multiple of the 16 rows that EXR compresses together, and the side of a tile.
constexpr int kRowsAtOnce = 64;

OIIO::TypeDesc sampleType(StorageFormat format) {
    switch (format) {
        case StorageFormat::Float:
            return OIIO::TypeDesc::FLOAT;
        case StorageFormat::Half:
            return OIIO::TypeDesc::HALF;
        case StorageFormat::U16:
            return OIIO::TypeDesc::UINT16;
        case StorageFormat::U8:
            break;
    }
    return OIIO::TypeDesc::UINT8;
}

OIIO::ImageSpec specOf(const ImageDescription& description, const ImageLevel& level, bool isPng) {
    OIIO::ImageSpec spec(level.width, level.height, static_cast<int>(level.channels.size()),
                         sampleType(description.format));
    if (!description.channelNames.empty()) {
        spec.channelnames = description.channelNames;
        spec.alpha_channel = -1;
    }
    for (const auto& [name, value] : description.attributes)
        spec.attribute(name, value);
    spec.attribute("DateTime", kFixedDate);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    // Without this PNG data would read back as colours. (TIFF needs none, and a TIFF file with sRGB
    // comes out damaged.)
    if (isPng)
        spec.attribute("oiio:ColorSpace", description.isColour ? "sRGB" : "Linear");
    return spec;
}

/// Lets OpenImageIO write into an AtomicFile. Image libraries lose the reason why a write failed,
/// and some the failure itself: it is kept here. It must not pass through their C code.
class AtomicFileProxy : public OIIO::Filesystem::IOProxy {
  public:
    AtomicFileProxy(const std::string& name, AtomicFile& file)
        : IOProxy(name, Write), file_(file) {}
    [[nodiscard]] const char* proxytype() const override { return "atomic"; }
    std::size_t write(const void* bytes, std::size_t size) override {
        const std::size_t written = pwrite(bytes, size, m_pos);
        m_pos += static_cast<std::int64_t>(written);
        return written;
    }
    std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
        if (failure_)
            return 0;
        try {
            file_.writeAt(offset, {static_cast<const std::byte*>(bytes), size});
        } catch (const InputError&) {
            failure_ = std::current_exception();
            return 0;
        }
        size_ = std::max(size_, static_cast<std::size_t>(offset) + size);
        return size;
    }
    [[nodiscard]] std::size_t size() const override { return size_; }
    void rethrowFailure() const {
        if (failure_)
            std::rethrow_exception(failure_);
    }

  private:
    AtomicFile& file_;
    std::size_t size_ = 0;
    std::exception_ptr failure_;
};

/// Some rows of a level, interleaved as the file wants them.
template <class Sample>
void interleave(const ImageLevel& level, int first, int end, std::vector<Sample>& samples) {
    const auto width = static_cast<std::size_t>(level.width);
    const std::size_t channels = level.channels.size();
    std::vector<float> row(width);
    samples.resize(width * channels * static_cast<std::size_t>(end - first));
    for (int j = first; j < end; ++j)
        for (std::size_t c = 0; c < channels; ++c) {
            level.channels[c](j, row);
            Sample* sample = &samples[static_cast<std::size_t>(j - first) * width * channels + c];
            for (std::size_t i = 0; i < width; ++i, sample += channels)
                *sample = static_cast<Sample>(row[i]);
        }
}

template <class Sample>
bool writeLevel(OIIO::ImageOutput& output, const ImageLevel& level, OIIO::TypeDesc type) {
    std::vector<Sample> samples;
    for (int first = 0; first < level.height; first += kRowsAtOnce) {
        const int end = std::min(first + kRowsAtOnce, level.height);
        interleave(level, first, end, samples);
        const bool good =
            output.spec().tile_width > 0
                ? output.write_tiles(0, level.width, first, end, 0, 1, type, samples.data())
                : output.write_scanlines(first, end, 0, type, samples.data());
        if (!good)
            return false;
    }
    return true;
}

bool writeSamples(OIIO::ImageOutput& output, const ImageLevel& level, StorageFormat format) {
    switch (format) {
        case StorageFormat::U8:
            return writeLevel<std::uint8_t>(output, level, OIIO::TypeDesc::UINT8);
        case StorageFormat::U16:
            return writeLevel<std::uint16_t>(output, level, OIIO::TypeDesc::UINT16);
        case StorageFormat::Half:
        case StorageFormat::Float:
            break;
    }
    return writeLevel<float>(output, level, OIIO::TypeDesc::FLOAT);
}

/// Files with MIP levels are tiled: the libraries ask for it.
bool writeLevels(OIIO::ImageOutput& output, const std::string& name,
                 const ImageDescription& description, std::span<const ImageLevel> levels) {
    const bool isPng = lowerExtension(name) == ".png";
    // TIFF has none; there they are further pictures of the file.
    const bool hasMips = output.supports("mipmap") != 0;
    const auto furtherLevel =
        hasMips ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
    for (const ImageLevel& level : levels) {
        const bool isFirst = &level == &levels.front();
        OIIO::ImageSpec spec = specOf(description, level, isPng);
        if (levels.size() > 1) {
            spec.tile_width = spec.tile_height = kRowsAtOnce;
            spec.tile_depth = 1;
            if (hasMips)
                spec.attribute("textureformat", "Plain Texture");
        }
        if (!output.open(name, spec, isFirst ? OIIO::ImageOutput::Create : furtherLevel) ||
            !writeSamples(output, level, description.format))
            return false;
    }
    return output.close();
}

/// Where no proxy sees a failure, a file that could not be finished lacks its end.
void requireWhole(const std::filesystem::path& file, const std::filesystem::path& written) {
    try {
        ImageReader(written, kLargestMap).requireEnd();
    } catch (const InputError&) {
        throw InputError(
            fmt::format("{}: cannot be written whole: is the disk full?", file.string()));
    }
}

}  // namespace

void writeImage(const std::filesystem::path& file, const ImageDescription& description,
                std::span<const ImageLevel> levels) {
    assert(!levels.empty() && !levels.front().channels.empty());
    AtomicFile target(file);
    // OpenImageIO opens a TIFF file anew for each level, which a proxy cannot follow: by name.
    const bool isByName = levels.size() > 1 && lowerExtension(file) != ".exr";
    const std::string name = isByName ? target.path().string() : file.string();
    AtomicFileProxy proxy(name, target);
    const std::unique_ptr<OIIO::ImageOutput> output =
        OIIO::ImageOutput::create(name, isByName ? nullptr : &proxy);
    const bool good = output && writeLevels(*output, name, description, levels);
    proxy.rethrowFailure();
    if (!good)
        throw InputError(fmt::format("{}: cannot be encoded: {}", file.string(),
                                     output ? output->geterror() : OIIO::geterror()));
    if (isByName)
        requireWhole(file, target.path());
    target.commit();
}

void writeImage(const std::filesystem::path& file, const ImageContent& content) {
    assert(!content.planes.empty());
    ImageLevel level{content.planes.front().width, content.planes.front().height, {}};
    for (const Plane& plane : content.planes)
        level.channels.emplace_back([&plane](int row, std::span<float> samples) {
            std::copy_n(&plane.texels[plane.index(0, row)], samples.size(), samples.begin());
        });
    writeImage(file, content, std::span(&level, 1));
}

}  // namespace relievo::textures
