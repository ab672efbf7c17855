// What is said of limits beside whether they are kept: from what their heights count, and who moves
// sideways where a show says that none does.
#pragma once

#include "analysis/recorded/verify_paths.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

// " above mean sea level", of heights that count from there.
std::string counted_from_sea(const io::Recording& recording);

// Of a breach of `most_m` by heights that count from the sea: that a limit of law counts from the
// ground, and what to type. Empty where they do not.
std::string ground_hint(const io::Recording& recording, const analysis::PathBreach& worst,
                        double most_m);

// "minNavAltitude 2.5 m: kept", of those that are; empty where none is.
std::string kept_navigation(const analysis::PathVerdict& verdict);

// Who moves sideways below a height: a line for each of those.
std::vector<std::string> low_moves(const analysis::PathVerdict& verdict,
                                   const io::Recording& recording);

// Of names of limits those that were looked at, or those that were not.
std::vector<std::string> looked_at(const std::vector<std::string>& names,
                                   const analysis::PathVerdict& verdict, bool wanted);

void write_navigation(io::JsonWriter& json, const analysis::PathVerdict& verdict,
                      const io::Recording& recording);

}  // namespace beespace::cli
