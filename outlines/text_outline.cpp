#include "outlines/text_outline.h"

#include <fmt/format.h>
#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <memory>
#include <span>

#include "outlines/curve_flattening.h"
#include "textures/input_error.h"

namespace relievo::outlines {
namespace {

constexpr double kMargin = 0.125;  // of the height of the text

template <auto destroy>
struct Destroy {
    template <typename Object>
    void operator()(Object* object) const {
        destroy(object);
    }
};
using Blob = std::unique_ptr<hb_blob_t, Destroy<hb_blob_destroy>>;
using Face = std::unique_ptr<hb_face_t, Destroy<hb_face_destroy>>;
using Font = std::unique_ptr<hb_font_t, Destroy<hb_font_destroy>>;
using Buffer = std::unique_ptr<hb_buffer_t, Destroy<hb_buffer_destroy>>;
using DrawFunctions = std::unique_ptr<hb_draw_funcs_t, Destroy<hb_draw_funcs_destroy>>;

// A curve of a glyph, of degree 1 to 3, and where it begins; in font units, y upwards.
struct Curve {
    std::array<glm::dvec2, 4> points;
    int degree;
};

// What the callbacks of hb_font_get_glyph_shape write to: contours as curves.
struct Pen {
    glm::dvec2 origin{0.0};  // of the glyph
    std::vector<std::vector<Curve>> contours;

    void begin() { contours.emplace_back(); }
    void add(const hb_draw_state_t& state, std::initializer_list<glm::dvec2> points) {
        Curve curve{{}, static_cast<int>(points.size())};
        curve.points[0] = origin + glm::dvec2(state.current_x, state.current_y);
        std::transform(points.begin(), points.end(), curve.points.begin() + 1,
                       [this](const glm::dvec2& point) { return origin + point; });
        contours.back().push_back(curve);
    }
};

Pen& penOf(void* data) {
    return *static_cast<Pen*>(data);
}

DrawFunctions makeDrawFunctions() {
    DrawFunctions functions(hb_draw_funcs_create());
    hb_draw_funcs_set_move_to_func(
        functions.get(),
        [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float, float, void*) {
            penOf(data).begin();
        },
        nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(
        functions.get(),
        [](hb_draw_funcs_t*, void* data, hb_draw_state_t* state, float x, float y, void*) {
            penOf(data).add(*state, {{x, y}});
        },
        nullptr, nullptr);
    hb_draw_funcs_set_quadratic_to_func(
        functions.get(),
        [](hb_draw_funcs_t*, void* data, hb_draw_state_t* state, float x1, float y1, float x,
           float y, void*) {
            penOf(data).add(*state, {{x1, y1}, {x, y}});
        },
        nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(
        functions.get(),
        [](hb_draw_funcs_t*, void* data, hb_draw_state_t* state, float x1, float y1, float x2,
           float y2, float x, float y, void*) {
            penOf(data).add(*state, {{x1, y1}, {x2, y2}, {x, y}});
        },
        nullptr, nullptr);
    return functions;
}

Font openFont(const std::filesystem::path& file) {
    const Blob blob(hb_blob_create_from_file_or_fail(file.c_str()));
    if (!blob)
        throw textures::InputError(fmt::format("{}: cannot be read", file.string()));
    const Face face(hb_face_create(blob.get(), 0));
    if (hb_face_get_glyph_count(face.get()) == 0)
        throw textures::InputError(
            fmt::format("{}: is no font; TrueType or OpenType was expected", file.string()));
    return Font(hb_font_create(face.get()));
}

// HarfBuzz would put its own sign in the place of what is no UTF-8.
void requireUtf8(const std::filesystem::path& file, const std::string& text) {
    constexpr hb_codepoint_t kNoLetter = UINT32_MAX;
    const Buffer buffer(hb_buffer_create());
    hb_buffer_set_replacement_codepoint(buffer.get(), kNoLetter);
    hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
    unsigned count = 0;
    const hb_glyph_info_t* const letters = hb_buffer_get_glyph_infos(buffer.get(), &count);
    for (const hb_glyph_info_t& letter : std::span(letters, count))
        if (letter.codepoint == kNoLetter)
            throw textures::InputError(fmt::format("{}: the text is no UTF-8 at its byte {}",
                                                   file.string(), letter.cluster));
}

Buffer shape(const std::filesystem::path& file, hb_font_t* font, const std::string& text) {
    requireUtf8(file, text);
    Buffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
    hb_buffer_guess_segment_properties(buffer.get());
    hb_shape(font, buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer.get(), &count);
    for (const hb_glyph_info_t& glyph : std::span(glyphs, count))
        if (glyph.codepoint == 0)
            throw textures::InputError(
                fmt::format("{}: has no glyph for what begins at byte {} of '{}'", file.string(),
                            glyph.cluster, text));
    return buffer;
}

std::vector<std::vector<Curve>> draw(hb_font_t* font, hb_buffer_t* buffer) {
    const DrawFunctions functions = makeDrawFunctions();
    unsigned count = 0;
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer, &count);
    Pen pen;
    glm::dvec2 place(0.0);
    for (unsigned k = 0; k < count; ++k) {
        pen.origin = place + glm::dvec2(places[k].x_offset, places[k].y_offset);
        hb_font_get_glyph_shape(font, glyphs[k].codepoint, functions.get(), &pen);
        place += glm::dvec2(places[k].x_advance, places[k].y_advance);
    }
    return std::move(pen.contours);
}

// The box of the control points, which holds the curves.
struct Box {
    glm::dvec2 least{std::numeric_limits<double>::infinity()};
    glm::dvec2 most{-std::numeric_limits<double>::infinity()};
};

Box boxOf(const std::vector<std::vector<Curve>>& contours) {
    Box box;
    for (const std::vector<Curve>& contour : contours)
        for (const Curve& curve : contour)
            for (int k = 0; k <= curve.degree; ++k) {
                const glm::dvec2& point = curve.points[static_cast<std::size_t>(k)];
                box.least = glm::min(box.least, point);
                box.most = glm::max(box.most, point);
            }
    return box;
}

void append(const Curve& curve, double tolerance, Contour& contour) {
    const auto& [a, b, c, d] = curve.points;
    if (curve.degree == 1)
        contour.push_back(b);
    else if (curve.degree == 2)
        appendQuadratic({a, b, c}, tolerance, contour);
    else
        appendCubic({a, b, c, d}, tolerance, contour);
}

}  // namespace

Drawing readTextDrawing(const std::filesystem::path& file, const std::string& text,
                        double tolerance) {
    const Font font = openFont(file);
    const Buffer buffer = shape(file, font.get(), text);
    const std::vector<std::vector<Curve>> contours = draw(font.get(), buffer.get());
    const Box box = boxOf(contours);
    const glm::dvec2 size = box.most - box.least;
    if (!(size.x > 0.0 && size.y > 0.0))
        throw textures::InputError(fmt::format(
            "{}: the text '{}' covers nothing; letters were expected", file.string(), text));
    const double margin = kMargin * size.y;
    const double width = size.x + 2.0 * margin;
    Outline outline;
    for (const std::vector<Curve>& curves : contours) {
        Contour& contour = outline.contours.emplace_back();
        for (const Curve& curve : curves)
            append(curve, tolerance * width, contour);
        // From font units, y upwards, to tile widths, y downwards.
        for (glm::dvec2& point : contour)
            point =
                glm::dvec2(point.x - box.least.x + margin, box.most.y + margin - point.y) / width;
    }
    Drawing drawing;
    drawing.shapes.push_back(std::move(outline));
    drawing.aspect = (size.y + 2.0 * margin) / width;
    return drawing;
}

}  // namespace relievo::outlines
