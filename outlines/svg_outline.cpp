#include "outlines/svg_outline.h"

#include <2geom/pathvector.h>
#include <2geom/sbasis-to-bezier.h>
#include <2geom/svg-path-parser.h>
#include <2geom/transforms.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "outlines/curve_flattening.h"
#include "textures/input_error.h"

namespace relievo::outlines {
namespace {

using Numbers = std::vector<double>;

// What of a drawing is being read: a group's transform holds for all that is in it.
struct Reader {
    std::string file;
    double tolerance;  // tile widths
    Drawing drawing;

    [[noreturn]] void fail(const pugi::xml_node& element, const std::string& what) const {
        throw textures::InputError(fmt::format("{}: the element <{}> at byte {} {}", file,
                                               element.name(), element.offset_debug(), what));
    }
};

// Numbers with white space and commas between them, as SVG has them; nothing where there is more.
std::optional<Numbers> numbersOf(const std::string& text) {
    Numbers numbers;
    const char* next = text.c_str();
    while (true) {
        next += std::strspn(next, " \t\r\n,");
        if (*next == '\0')
            return numbers;
        char* end = nullptr;
        const double number = std::strtod(next, &end);
        if (end == next || !std::isfinite(number))
            return std::nullopt;
        numbers.push_back(number);
        next = end;
    }
}

std::optional<Geom::Affine> transformFunction(std::string_view name, const Numbers& n) {
    const auto radians = [](double degrees) { return degrees * M_PI / 180.0; };
    if (name == "matrix" && n.size() == 6)
        return Geom::Affine(n[0], n[1], n[2], n[3], n[4], n[5]);
    if (name == "translate" && (n.size() == 1 || n.size() == 2))
        return Geom::Translate(n[0], n.size() == 2 ? n[1] : 0.0);
    if (name == "scale" && (n.size() == 1 || n.size() == 2))
        return Geom::Scale(n[0], n.size() == 2 ? n[1] : n[0]);
    if (name == "rotate" && n.size() == 1)
        return Geom::Rotate(radians(n[0]));
    if (name == "rotate" && n.size() == 3)
        return Geom::Translate(-n[1], -n[2]) * Geom::Rotate(radians(n[0])) *
               Geom::Translate(n[1], n[2]);
    if (name == "skewX" && n.size() == 1)
        return Geom::HShear(std::tan(radians(n[0])));
    if (name == "skewY" && n.size() == 1)
        return Geom::VShear(std::tan(radians(n[0])));
    return std::nullopt;
}

// The transform attribute: functions, of which the last is applied first.
Geom::Affine transformOf(const Reader& reader, const pugi::xml_node& element) {
    std::string text = element.attribute("transform").value();
    Geom::Affine transform = Geom::identity();
    while (text.find_first_not_of(" \t\r\n,") != std::string::npos) {
        const std::size_t begin = text.find_first_not_of(" \t\r\n,");
        const std::size_t open = text.find('(');
        const std::size_t close = text.find(')');
        std::optional<Geom::Affine> function;
        if (open != std::string::npos && close != std::string::npos && begin < open && open < close)
            if (const auto numbers = numbersOf(text.substr(open + 1, close - open - 1)))
                function = transformFunction(
                    text.substr(begin, text.find_last_not_of(" \t\r\n", open - 1) + 1 - begin),
                    *numbers);
        if (!function)
            reader.fail(element,
                        fmt::format("has the transform '{}', which is none of SVG's", text));
        transform = *function * transform;
        text.erase(0, close + 1);
    }
    return transform;
}

// A presentation attribute, or the same in the attribute style, which is stronger.
std::string propertyOf(const pugi::xml_node& element, const std::string& name) {
    const std::string style = element.attribute("style").value();
    std::string value = element.attribute(name.c_str()).value();
    for (std::size_t begin = 0; begin < style.size();) {
        const std::size_t end = std::min(style.find(';', begin), style.size());
        const std::string declaration = style.substr(begin, end - begin);
        const std::size_t colon = declaration.find(':');
        const auto trimmed = [](const std::string& text) {
            const std::size_t first = text.find_first_not_of(" \t\r\n");
            return first == std::string::npos
                       ? std::string()
                       : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
        };
        if (colon != std::string::npos && trimmed(declaration.substr(0, colon)) == name)
            value = trimmed(declaration.substr(colon + 1));
        begin = end + 1;
    }
    return value;
}

double lengthOf(const Reader& reader, const pugi::xml_node& element, const char* name) {
    const std::string text = element.attribute(name).value();
    char* end = nullptr;
    const double length = std::strtod(text.c_str(), &end);
    const std::string_view unit = end;
    if (text.empty())
        return 0.0;
    if (end == text.c_str() || !std::isfinite(length) || !(unit.empty() || unit == "px"))
        reader.fail(element,
                    fmt::format("has {}='{}'; a number of user units was expected", name, text));
    return length;
}

std::string ellipseData(double x, double y, double rx, double ry) {
    return fmt::format("M{},{} a{},{} 0 1 0 {},0 a{},{} 0 1 0 {},0 z", x - rx, y, rx, ry, 2 * rx,
                       rx, ry, -2 * rx);
}

std::string rectangleData(const Reader& reader, const pugi::xml_node& element) {
    const auto length = [&](const char* name) { return lengthOf(reader, element, name); };
    const double width = length("width");
    const double height = length("height");
    const bool hasX = !element.attribute("rx").empty();
    const bool hasY = !element.attribute("ry").empty();
    const double rx = std::min(length(hasX ? "rx" : "ry"), 0.5 * width);
    const double ry = std::min(length(hasY ? "ry" : "rx"), 0.5 * height);
    if (!(width > 0.0 && height > 0.0))
        return {};
    if (!(rx > 0.0 && ry > 0.0))
        return fmt::format("M{},{} h{} v{} h{} z", length("x"), length("y"), width, height, -width);
    return fmt::format(
        "M{0},{1} h{2} a{4},{5} 0 0 1 {4},{5} v{3} a{4},{5} 0 0 1 {6},{5} h{8} "
        "a{4},{5} 0 0 1 {6},{7} v{9} a{4},{5} 0 0 1 {4},{7} z",
        length("x") + rx, length("y"), width - 2 * rx, height - 2 * ry, rx, ry, -rx, -ry,
        -(width - 2 * rx), -(height - 2 * ry));
}

// The path data of a filled element, and whether it is one.
std::optional<std::string> pathData(const Reader& reader, const pugi::xml_node& element) {
    const std::string_view name = element.name();
    const auto length = [&](const char* attribute) { return lengthOf(reader, element, attribute); };
    if (name == "path")
        return element.attribute("d").value();
    if (name == "rect")
        return rectangleData(reader, element);
    if (name == "circle")
        return ellipseData(length("cx"), length("cy"), length("r"), length("r"));
    if (name == "ellipse")
        return ellipseData(length("cx"), length("cy"), length("rx"), length("ry"));
    if (name == "polygon" || name == "polyline")
        return fmt::format("M{} z", element.attribute("points").value());
    return std::nullopt;
}

glm::dvec2 pointOf(const Geom::Point& point) {
    return {point[Geom::X], point[Geom::Y]};
}

void appendCurve(const Geom::Curve& curve, double tolerance, Contour& contour) {
    if (const auto* bezier = dynamic_cast<const Geom::BezierCurve*>(&curve)) {
        const auto point = [&](unsigned k) { return pointOf(bezier->controlPoint(k)); };
        if (bezier->order() == 1)
            contour.push_back(point(1));
        else if (bezier->order() == 2)
            appendQuadratic({point(0), point(1), point(2)}, tolerance, contour);
        else
            appendCubic({point(0), point(1), point(2), point(3)}, tolerance, contour);
        return;
    }
    // An arc of an ellipse.
    const Geom::Path cubics = Geom::cubicbezierpath_from_sbasis(curve.toSBasis(), 0.1 * tolerance);
    for (const Geom::Curve& part : cubics)
        appendCurve(part, 0.9 * tolerance, contour);
}

Outline outlineOf(const Geom::PathVector& paths, FillRule rule, double tolerance) {
    Outline outline{{}, rule};
    for (const Geom::Path& path : paths) {
        Contour& contour = outline.contours.emplace_back();
        contour.push_back(pointOf(path.initialPoint()));
        for (const Geom::Curve& curve : path)
            appendCurve(curve, tolerance, contour);
    }
    return outline;
}

Geom::PathVector pathsOf(const Reader& reader, const pugi::xml_node& element,
                         const std::string& data) {
    try {
        return Geom::parse_svg_path(data.c_str());
    } catch (const std::exception&) {
        reader.fail(element, fmt::format("has the path '{:.60}', which is no path of SVG's", data));
    }
}

void readElement(Reader& reader, const pugi::xml_node& element, const Geom::Affine& around,
                 FillRule inherited, bool isFilled);

void readChildren(Reader& reader, const pugi::xml_node& parent, const Geom::Affine& around,
                  FillRule inherited, bool isFilled) {
    for (const pugi::xml_node& child : parent.children())
        if (child.type() == pugi::node_element)
            readElement(reader, child, around, inherited, isFilled);
}

void readElement(Reader& reader, const pugi::xml_node& element, const Geom::Affine& around,
                 FillRule inherited, bool isFilled) {
    const std::string_view name = element.name();
    if (name == "use" || name == "text" || name == "style" || name == "image")
        reader.fail(element, "is not supported; paths and basic shapes were expected");
    if (propertyOf(element, "display") == "none")
        return;
    const std::string fill = propertyOf(element, "fill");
    if (!fill.empty())
        isFilled = fill != "none";
    const std::string rule = propertyOf(element, "fill-rule");
    if (!rule.empty())
        inherited = rule == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    const Geom::Affine transform = transformOf(reader, element) * around;
    if (name == "g" || name == "svg" || name == "a") {
        readChildren(reader, element, transform, inherited, isFilled);
    } else if (const std::optional<std::string> data = pathData(reader, element);
               data && isFilled && !data->empty()) {
        const Geom::PathVector paths = pathsOf(reader, element, *data) * transform;
        reader.drawing.shapes.push_back(outlineOf(paths, inherited, reader.tolerance));
    }
}

// x, y, width and height of what is drawn.
Numbers viewBoxOf(const Reader& reader, const pugi::xml_node& root) {
    const std::string text = root.attribute("viewBox").value();
    const auto numbers = text.empty() ? Numbers{0.0, 0.0, lengthOf(reader, root, "width"),
                                                lengthOf(reader, root, "height")}
                                      : numbersOf(text);
    if (!numbers || numbers->size() != 4 || !((*numbers)[2] > 0.0 && (*numbers)[3] > 0.0))
        reader.fail(root,
                    "has no size: a viewBox, or a width and a height in user units, was expected");
    return *numbers;
}

}  // namespace

Drawing readSvgDrawing(const std::filesystem::path& file, double tolerance) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_file(file.c_str());
    if (!parsed)
        throw textures::InputError(fmt::format("{}: cannot be read as SVG ({} at byte {})",
                                               file.string(), parsed.description(), parsed.offset));
    const pugi::xml_node root = document.document_element();
    if (std::string_view(root.name()) != "svg")
        throw textures::InputError(
            fmt::format("{}: is XML but no SVG: its first element is <{}>, <svg> was expected",
                        file.string(), root.name()));
    Reader reader{file.string(), tolerance, {}};
    const Numbers box = viewBoxOf(reader, root);
    reader.drawing.aspect = box[3] / box[2];
    const Geom::Affine toTile = Geom::Translate(-box[0], -box[1]) * Geom::Scale(1.0 / box[2]);
    readChildren(reader, root, toTile, FillRule::NonZero, true);
    return reader.drawing;
}

}  // namespace relievo::outlines
