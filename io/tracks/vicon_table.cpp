#include "io/tracks/vicon_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/body_records.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

// In the order in which they are preferred.
enum class SectionKind : std::uint8_t { kObjects, kSegments, kMarkers };

struct ViconSection {
  SectionKind kind = SectionKind::kObjects;
  BodyTable table = {};
  std::string_view rows = {};
};

std::optional<SectionKind> kind_of(const std::vector<std::string>& cells) {
  if (cells.empty()) return std::nullopt;
  if (cells[0] == "Objects") return SectionKind::kObjects;
  if (cells[0] == "Segments" || cells[0] == "Model Outputs") return SectionKind::kSegments;
  if (cells[0] == "Trajectories") return SectionKind::kMarkers;
  return std::nullopt;
}

bool is_end_of_section(std::string_view line) {
  return line.find_first_not_of(", \t\r") == std::string_view::npos;
}

// The columns called as `axes`, each three under the name above them.
std::vector<BodyColumns> bodies_under(const std::vector<std::string>& whose,
                                      const std::vector<std::string>& names,
                                      const std::array<std::string_view, 3>& axes) {
  std::vector<BodyColumns> bodies;
  std::string name;
  for (std::size_t column = 0; column + 2 < names.size(); ++column) {
    if (column < whose.size() && !whose[column].empty()) name = whose[column];
    const bool three =
        names[column] == axes[0] && names[column + 1] == axes[1] && names[column + 2] == axes[2];
    if (three) bodies.push_back({name, {column, column + 1, column + 2}});
  }
  return bodies;
}

// The lines from `at` on, if they are the header of a section; `at` and `lines` are then behind it.
std::optional<ViconSection> section_at(std::string_view text, std::size_t& at,
                                       std::uint64_t& lines) {
  constexpr std::size_t kHeaderLines = 5;
  std::array<std::vector<std::string>, kHeaderLines> header;
  std::size_t offset = at;
  for (std::vector<std::string>& cells : header) {
    const Line line = line_at(text, offset, '\n');
    if (line.text.size() > kLongestLine) return std::nullopt;
    cells = cells_of_line(line.text, ',');
    offset = line.next;
    if (offset >= text.size()) return std::nullopt;
  }
  const auto& [title, rates, whose, names, units] = header;
  const auto kind = kind_of(title);
  double rate = 0.0;
  const bool rated =
      !rates.empty() && parse_number(rates[0], rate) == NumberKind::kNumber && rate > 0.0;
  if (!kind || !rated || names.empty() || names[0] != "Frame") return std::nullopt;
  ViconSection section;
  section.kind = *kind;
  section.table.program = "Vicon (Nexus, Tracker)";
  section.table.pictures_per_second = rate;
  section.table.columns = names.size();
  section.table.bodies = *kind == SectionKind::kMarkers
                             ? bodies_under(whose, names, {"X", "Y", "Z"})
                             : bodies_under(whose, names, {"TX", "TY", "TZ"});
  if (!section.table.bodies.empty()) {
    const std::size_t first = section.table.bodies.front().axes[0];
    if (first < units.size()) section.table.unit = units[first];
  }
  lines += kHeaderLines;
  section.table.lines_before = lines;
  at = offset;
  return section;
}

// The section that is to be read; nothing where there is none with places.
std::optional<ViconSection> vicon_section(std::string_view text) {
  std::optional<ViconSection> best;
  std::size_t at = 0;
  std::uint64_t lines = 0;
  while (at < text.size()) {
    auto section = section_at(text, at, lines);
    if (!section && lines == 0) return std::nullopt;  // it is no such table
    const std::size_t begins = at;
    std::size_t ends = at;
    while (at < text.size()) {
      const Line line = line_at(text, at, '\n');
      at = line.next;
      ++lines;
      if (is_end_of_section(line.text)) break;
      ends = at;
    }
    if (!section || section->table.bodies.empty()) continue;
    section->rows = text.substr(begins, std::min(ends, text.size()) - begins);
    if (!best || section->kind < best->kind) best = std::move(section);
  }
  return best;
}

// "robot1" of "robot1:base", and of "Global Angle robot1:robot1", as Tracker calls objects.
std::string subject_of(const std::string& name) {
  constexpr std::string_view kOfObjects = "Global Angle ";
  const std::size_t ends = name.find(':');
  const std::size_t begins =
      ends != std::string::npos && name.starts_with(kOfObjects) ? kOfObjects.size() : 0;
  return name.substr(begins, ends == std::string::npos ? ends : ends - begins);
}

Error of_one_body(const ViconSection& section, const std::string& one, const std::string& other) {
  const bool markers = section.kind == SectionKind::kMarkers;
  return {ErrorCode::kInvalidArgument,
          std::string(markers ? "markers " : "segments ") + excerpt(one) + " and " +
              excerpt(other) + " are both of " + excerpt(subject_of(one)) +
              ", so that each would be a bee near the other; export " +
              (markers ? "objects or segments (rigid bodies) from Vicon instead of trajectories"
                       : "one segment of each from Vicon") +
              ", or leave the columns of the others out of the table",
          {}};
}

std::optional<Error> take_subjects(ViconSection& section) {
  std::vector<BodyColumns>& bodies = section.table.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name.find(':') == std::string::npos) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (subject_of(bodies[i].name) == subject_of(bodies[j].name)) {
        return of_one_body(section, bodies[j].name, bodies[i].name);
      }
    }
  }
  for (BodyColumns& body : bodies) body.name = subject_of(body.name);
  if (!has_unclear_names(bodies)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "two of the bodies of this export of Vicon have one name, or none: give each a name "
               "of its own, and export it again",
               {}};
}

}  // namespace

bool is_vicon_table(std::string_view text) {
  return vicon_section(text).has_value();
}

std::optional<Error> read_vicon_table(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  auto section = vicon_section(text);
  if (!section) return Error{ErrorCode::kUnsupportedFormat, "this is no export of Vicon", {}};
  if (auto problem = take_subjects(*section)) return problem;
  const BodyTable& table = section->table;
  if (!is_one_of("mm cm m", table.unit)) {
    return Error{ErrorCode::kInvalidArgument,
                 "this export of Vicon has its places in " +
                     (table.unit.empty() ? "a unit that it does not name" : excerpt(table.unit)) +
                     "; export them in mm",
                 {}};
  }
  if (auto problem = own_beginning(table, assembly)) return problem;
  LongRecords records = body_records(section->rows, table);
  const std::size_t bodies = table.bodies.size();
  const bool markers = section->kind == SectionKind::kMarkers;
  const std::string_view what =
      markers ? (bodies == 1 ? " marker" : " markers") : (bodies == 1 ? " body" : " bodies");
  records.note = "positions of " + std::to_string(bodies) + std::string(what) +
                 " as Vicon exports them, " + exact(*table.pictures_per_second) +
                 " pictures a second";
  records.description = "export of Vicon";
  return read_long_records(records, {}, assembly);
}

}  // namespace beespace::io
