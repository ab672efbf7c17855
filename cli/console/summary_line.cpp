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

void append_note(std::string& out, const std::string& note) {
  if (!note.empty()) append_summary_line(out, "note", printable(note));
}

void append_vertical(std::string& out, const std::optional<io::StatedLength>& vertical,
                     io::Unit height_unit) {
  const std::string note = vertical_note(vertical, height_unit);
  if (!note.empty()) append_summary_line(out, "vertical", note);
}

std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive, const std::optional<io::StatedLength>& threshold,
                            const std::optional<io::StatedLength>& vertical) {
  const auto length = [inclusive](double metres, const std::optional<io::StatedLength>& stated) {
    std::string text = io::exact(metres) + " m";
    if (stated && stated->unit != io::Unit::kMetre) text += ", " + text_of(*stated);
    return text + (inclusive ? " or closer" : " (closer than)");
  };
  if (!vertical_m) return length(threshold_m, threshold);
  return "horizontally " + length(threshold_m, threshold) + ", and in height " +
         length(*vertical_m, vertical);
}

}  // namespace beespace::cli
