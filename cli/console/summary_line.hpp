// The lines of a summary, alike for all subcommands.
#pragma once

#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// "  label      text".
void append_summary_line(std::string& out, std::string_view label, std::string_view text);

// Which units were taken and why, a line each.
void append_units(std::string& out, const std::vector<io::UnitTaken>& units);

// Nothing where there is none.
void append_note(std::string& out, const std::string& note);

// How the vertical threshold is compared, where that is not in metres.
void append_vertical(std::string& out, const std::optional<io::StatedLength>& vertical,
                     io::Unit height_unit);

// "5 m (closer than)", or "horizontally 5 m or closer, and in height 2 m or closer"; of what was
// typed in another unit with that too, "9260 m, 5 NM (closer than)".
std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive, const std::optional<io::StatedLength>& threshold = {},
                            const std::optional<io::StatedLength>& vertical = {});

// Behind it, where the threshold was not given.
inline constexpr const char* kDefaultThresholdWords = ", the default (--threshold)";

}  // namespace beespace::cli
