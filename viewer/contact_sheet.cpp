#include "viewer/contact_sheet.h"

#include <algorithm>
#include <cassert>

#include "viewer/picture_text.h"

namespace relievo::viewer {
namespace {

constexpr int kGap = 8;
constexpr int kLabelHeight = 40;
constexpr float kBackground = 0.13f;

Picture makeBackground(int width, int height) {
    Picture sheet(width, height);
    for (std::size_t k = 0; k < sheet.rgba.size(); ++k)
        sheet.rgba[k] = k % 4 == 3 ? 1.0f : kBackground;
    return sheet;
}

// Cuts a label to the width of its picture, so that it cannot run into the next one.
std::string fitLabel(std::string text, int size, int width) {
    while (!text.empty() && textWidth(text, size) > width) {
        // Never leave half of a UTF-8 sequence.
        do
            text.pop_back();
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80);
    }
    return text;
}

}  // namespace

Picture makeContactSheet(const std::vector<std::vector<SheetCell>>& rows, const Picture& footer) {
    assert(!rows.empty() && !rows.front().empty());
    const int cellWidth = rows.front().front().picture.width;
    const int cellHeight = rows.front().front().picture.height;
    std::size_t columns = 0;
    for (const auto& row : rows)
        columns = std::max(columns, row.size());
    const int rowHeight = kLabelHeight + cellHeight + kGap;
    const int gridWidth = kGap + static_cast<int>(columns) * (cellWidth + kGap);
    Picture sheet =
        makeBackground(std::max(gridWidth, footer.width > 0 ? footer.width + 2 * kGap : 0),
                       static_cast<int>(rows.size()) * rowHeight +
                           (footer.height > 0 ? footer.height + kGap : kGap));
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            const SheetCell& cell = rows[r][c];
            const int x = kGap + static_cast<int>(c) * (cellWidth + kGap);
            const int y = static_cast<int>(r) * rowHeight;
            drawText(sheet, fitLabel(cell.title, 14, cellWidth), x, y + 18, 14, glm::vec3(0.95f));
            drawText(sheet, fitLabel(cell.subtitle, 11, cellWidth), x, y + 34, 11, glm::vec3(0.7f));
            paste(sheet, cell.picture, x, y + kLabelHeight);
        }
    if (footer.width > 0)
        paste(sheet, footer, kGap, static_cast<int>(rows.size()) * rowHeight);
    return sheet;
}

}  // namespace relievo::viewer
