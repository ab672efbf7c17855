#include "io/tracks/motion_capture.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"

#include <string>

namespace beespace::io {
namespace {

std::string_view program_of(std::string_view text) {
  if (text.starts_with("Format Version,")) return "Motive (OptiTrack)";
  if (text.starts_with("NO_OF_FRAMES\t")) return "QTM (Qualisys)";
  const Line first = line_at(text, 0, '\n');
  const auto title = without_padding(first.text.substr(0, first.text.find(',')));
  if (title != "Trajectories" && title != "Model Outputs" && title != "Objects") return {};
  const Line second = line_at(text, first.next, '\n');
  double rate = 0.0;
  const auto field = without_padding(second.text.substr(0, second.text.find(',')));
  return parse_number(field, rate) == NumberKind::kNumber ? "Vicon (Nexus, Tracker)"
                                                          : std::string_view();
}

}  // namespace

std::optional<Error> motion_capture_problem(std::string_view text) {
  const std::string_view program = program_of(text);
  if (program.empty()) return std::nullopt;
  return Error{
      ErrorCode::kUnsupportedFormat,
      "this is an export of " + std::string(program) +
          ", in which what was followed stands beside each other under a header of several "
          "lines; that is not read: write a table with a record for each body and time, "
          "with columns time_s, id, x_mm, y_mm, z_mm (or x_m, y_m, z_m)",
      {}};
}

}  // namespace beespace::io
