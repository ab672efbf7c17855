// One HTML file with everything in it: the page that web/ builds, and one swarm or two.
#pragma once

#include "report/columns.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::report {

// The page without data; empty in a build without it (BEESPACE_WEB=OFF).
std::string_view page_template();

// Takes a page piece by piece.
using PageSink = std::function<void(std::string_view)>;

// `swarms` are what snapshot_json() and recording_json() say, with their columns; of two, the first
// is before and the second after. The page without data has the place for them once.
void write_page(std::string_view page, const std::vector<std::string>& swarms,
                const Columns& columns, const PageSink& sink);

}  // namespace beespace::report
