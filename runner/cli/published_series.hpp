#pragma once
// Files of published points that a picture shows beside its cases.
//
// A file is CSV: comments (#), then a line with the names of the columns. kt and D_xy are needed; theta, in
// units of pi, and paper, the source, are not. Every other column is a parameter of a case, such as Ca.
// For a phase diagram the columns are the parameters of its axes, and paper.
#include <filesystem>
#include <vector>

#include "runner/cli/pictured_cases.hpp"
#include "runner/render/history_picture.hpp"
#include "runner/render/phase_diagram_picture.hpp"

namespace capstan {

/// The points that have the parameters of one of the cases: a series for each source. An empty cell has any
/// value. A point without a number in kt, such as "steady", is left out. Without a column paper the source is
/// the name of the file. Throws std::system_error when the file cannot be read, std::invalid_argument for
/// missing columns.
std::vector<PublishedSeries> published_series(const std::filesystem::path& file,
                                              const std::vector<PicturedCase>& cases);

/// The boundaries of a phase diagram that a file has, one for each source: points with numbers in the columns
/// of both axes. Throws like published_series.
std::vector<PublishedBoundary> published_boundaries(const std::filesystem::path& file, const std::string& x,
                                                    const std::string& y);

}  // namespace capstan
