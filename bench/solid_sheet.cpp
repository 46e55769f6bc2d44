#include "bench/solid_sheet.h"

#include <algorithm>
#include <iterator>

#include "bench/solid_figures.h"
#include "commands/progress.h"

namespace relievo::bench {
namespace {

struct FigureGroup {
    std::string_view name;
    std::vector<FigureRow> (*draw)(FigureFrames&);
};
constexpr FigureGroup kGroups[] = {{"maps", mapFigures},
                                   {"boxes", boxFigures},
                                   {"compared", comparedFigures},
                                   {"collection", collectionFigures},
                                   {"corners", cornerFigures}};

}  // namespace

const std::vector<std::string>& figureGroups() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const FigureGroup& group : kGroups)
            list.emplace_back(group.name);
        return list;
    }();
    return names;
}

viewer::Picture makeSolidSheet(const SheetOptions& options, std::string_view group) {
    const auto context = gl::createContext(options.backend);
    FigureFrames frames{options.width, options.height, options.size, {}};
    std::vector<FigureRow> rows;
    commands::Progress progress("groups", group == "all" ? std::size(kGroups) : 1);
    for (const FigureGroup& one : kGroups) {
        if (group != "all" && group != one.name)
            continue;
        std::ranges::move(one.draw(frames), std::back_inserter(rows));
        progress.advance();
    }
    return viewer::makeContactSheet(rows, {});
}

}  // namespace relievo::bench
