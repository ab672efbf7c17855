// The lines of a summary, alike for all subcommands.
#pragma once

#include "io/points/repeated_ids.hpp"
#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// "  label      text".
void append_summary_line(std::string& out, std::string_view label, std::string_view text);

// "heights in ft: the header names it: 'alt_ft'".
std::string text_of(const io::UnitTaken& taken);

// "3 records have the id of another one before: the first is 'a', of data rows 0 and 5".
std::string text_of(const io::RepeatedIds& repeated);

// Which units were taken and why, a line each.
void append_units(std::string& out, const std::vector<io::UnitTaken>& units);

// Both of these among the notes of a page or a picture.
void note_units(const std::vector<io::UnitTaken>& units,
                const std::optional<io::StatedLength>& vertical, io::Unit height_unit,
                std::vector<std::string>& notes);

// What heights are counted from; empty where that is not said.
std::string_view datum_text(io::HeightDatum datum);

// How the vertical threshold is compared, where that is not in metres.
void append_vertical(std::string& out, const std::optional<io::StatedLength>& vertical,
                     io::Unit height_unit);

// "5 m (closer than)", or "horizontally 5 m or closer, and in height 2 m or closer".
std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive);

// Behind it, where nobody gave the threshold.
inline constexpr const char* kDefaultThresholdWords = ", the default (--threshold)";

}  // namespace beespace::cli
