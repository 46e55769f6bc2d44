#pragma once

#include <vector>

#include "bench/figure_stage.h"

namespace relievo::bench {

using FigureRow = std::vector<viewer::SheetCell>;

/// Figures of the thesis on extrusion and revolution mapping, restaged with shapes of our own.
/// 4.1 and 4.5: a shape map, and what an extension does.
std::vector<FigureRow> mapFigures(FigureFrames& frames);
/// 4.11 to 4.15: repetitions, depths that are written, and boxes.
std::vector<FigureRow> boxFigures(FigureFrames& frames);
/// 4.18: a shape as a height map by searches of reliefs, and as an extrusion, with their lookups.
std::vector<FigureRow> comparedFigures(FigureFrames& frames);
/// 4.20 to 4.22: reliefs on meshes, extrusions and revolutions.
std::vector<FigureRow> collectionFigures(FigureFrames& frames);

/// Not of the thesis: sharp corners beside round ones, of maps of a quarter of the texels.
std::vector<FigureRow> cornerFigures(FigureFrames& frames);

}  // namespace relievo::bench
