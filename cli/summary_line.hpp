// The lines of a summary, alike for all subcommands.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace beespace::cli {

// "  label      text".
void append_summary_line(std::string& out, std::string_view label, std::string_view text);

// "5 m (closer than)", or "horizontally 5 m or closer, and in height 2 m or closer".
std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive);

// Behind it, where nobody gave the threshold.
inline constexpr const char* kDefaultThresholdWords = ", the default (--threshold)";

}  // namespace beespace::cli
