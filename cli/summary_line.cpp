#include "cli/summary_line.hpp"

#include "cli/number_text.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::cli {

void append_summary_line(std::string& out, std::string_view label, std::string_view text) {
  constexpr std::size_t kLabelWidth = 11;
  out += "  ";
  out += label;
  out.append(kLabelWidth - std::min(kLabelWidth, label.size()), ' ');
  out += text;
  out += '\n';
}

std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive) {
  const char* const how = inclusive ? " m or closer" : " m (closer than)";
  std::string text = exact(threshold_m) + how;
  if (!vertical_m) return text;
  return "horizontally " + text + ", and in height " + exact(*vertical_m) + how;
}

}  // namespace beespace::cli
