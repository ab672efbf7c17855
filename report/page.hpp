// One HTML file with everything in it: the page that web/ builds, and one swarm or two.
#pragma once

#include "io/json/json_writer.hpp"
#include "report/columns.hpp"
#include "report/ground.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace beespace::report {

// The page without data; empty in a build without it (BEESPACE_WEB=OFF).
std::string_view page_template();

// Takes a page piece by piece.
using PageSink = std::function<void(std::string_view)>;

// What a page says in JSON: `write_swarms` writes one swarm, or two, of which the first is before
// and the second after, each by write_swarm().
std::string page_json(const std::function<void(io::JsonWriter&)>& write_swarms,
                      Ground ground = Ground::kWithout);

// With that, and its columns; and with the ground that is in the page without data, or without it.
// That page has the place for all these once.
void write_page(std::string_view page, std::string_view json, const Columns& columns,
                const PageSink& sink, Ground ground = Ground::kWithout);

}  // namespace beespace::report
