#include "cli/console/summary_line.hpp"

#include "analysis/text/unit_notes.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

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

void append_units(std::string& out, const std::vector<io::UnitTaken>& units) {
  for (const io::UnitTaken& taken : units) {
    append_summary_line(out, "units", printable(analysis::text_of(taken)));
  }
}

void append_vertical(std::string& out, const std::optional<io::StatedLength>& vertical,
                     io::Unit height_unit) {
  const std::string note = vertical_note(vertical, height_unit);
  if (!note.empty()) append_summary_line(out, "vertical", note);
}

std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive) {
  const char* const how = inclusive ? " m or closer" : " m (closer than)";
  std::string text = io::exact(threshold_m) + how;
  if (!vertical_m) return text;
  return "horizontally " + text + ", and in height " + io::exact(*vertical_m) + how;
}

}  // namespace beespace::cli
