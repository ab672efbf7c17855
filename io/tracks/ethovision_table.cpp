#include "io/tracks/ethovision_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/long_records.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::io {
namespace {

// What is read, as EthoVision calls it and as it is called here.
constexpr std::array<std::string_view, 3> kNamed = {"Trial time", "X center", "Y center"};
constexpr std::array<std::string_view, 3> kCalled = {"time", "x", "y"};
constexpr std::size_t kMostHeaderLines = 200;

struct EthovisionLayout {
  char delimiter = ';';
  std::size_t columns = 0;
  std::array<std::size_t, kNamed.size()> read = {};
  std::array<std::string, kNamed.size()> units = {};  // empty where no row says them
  std::size_t offset = 0;                             // where the records begin
  std::uint64_t lines_before = 0;
  std::string trial;
  std::string began;
  std::string arena;
  std::string subject;
};

bool find_named(const std::vector<std::string>& names, EthovisionLayout& layout) {
  for (std::size_t i = 0; i < kNamed.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), kNamed[i]);
    if (found == names.end()) return false;
    layout.read[i] = static_cast<std::size_t>(found - names.begin());
  }
  layout.columns = names.size();
  return std::find(names.begin(), names.end(), "Recording time") != names.end();
}

void take_fact(const std::vector<std::string>& cells, EthovisionLayout& layout) {
  if (cells.size() < 2) return;
  if (cells[0] == "Trial name") layout.trial = cells[1];
  if (cells[0] == "Start time") layout.began = cells[1];
  if (cells[0] == "Arena name") layout.arena = cells[1];
  if (cells[0] == "Subject name") layout.subject = cells[1];
}

// The row below the names, where it is no record.
void take_units(std::string_view text, EthovisionLayout& layout) {
  const Line line = line_at(text, layout.offset, '\n');
  const std::vector<std::string> cells = cells_of_line(line.text, layout.delimiter);
  double number = 0.0;
  const bool units = cells.size() == layout.columns && !cells[layout.read[0]].empty() &&
                     parse_number(cells[layout.read[0]], number) == NumberKind::kNotANumber &&
                     cells[layout.read[0]] != "-";
  if (!units) return;
  for (std::size_t i = 0; i < kNamed.size(); ++i) layout.units[i] = cells[layout.read[i]];
  layout.offset = line.next;
  ++layout.lines_before;
}

std::optional<EthovisionLayout> ethovision_layout(std::string_view text) {
  constexpr std::string_view kBegins = "Number of header lines";
  const Line first = line_at(text, 0, '\n');
  const bool whole = first.text.substr(0, kBegins.size() + 1).find(kBegins) < 2;
  for (const char delimiter : {';', ',', '\t'}) {
    EthovisionLayout layout;
    layout.delimiter = delimiter;
    for (std::size_t i = 0; i < kMostHeaderLines && layout.offset < text.size(); ++i) {
      const Line line = line_at(text, layout.offset, '\n');
      if (line.text.size() > kLongestLine) break;
      const std::vector<std::string> cells = cells_of_line(line.text, delimiter);
      layout.offset = line.next;
      ++layout.lines_before;
      if (find_named(cells, layout)) {
        take_units(text, layout);
        return layout;
      }
      if (!whole) break;
      take_fact(cells, layout);
    }
  }
  return std::nullopt;
}

LongRecords records_of_trial(std::string_view text, const EthovisionLayout& layout) {
  LongRecords records;
  for (std::size_t i = 0; i < kNamed.size(); ++i) {
    std::string name(kCalled[i]);
    if (i == 0 && layout.units[i].empty()) name = "time_s";
    if (!layout.units[i].empty()) name += " [" + layout.units[i] + "]";
    records.names.push_back(std::move(name));
  }
  records.lines_before = layout.lines_before;
  std::uint64_t lines = 0;
  RecordWalk walk(text, layout.offset, '\n');
  while (walk.next()) {
    records.text.append(walk.line() - lines, '\n');
    lines = walk.line() + 1;
    std::vector<std::string> cells = cells_of_line(walk.record(), layout.delimiter);
    // Each row may end with a delimiter.
    if (cells.size() == layout.columns + 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() != layout.columns) {
      records.text.append("a row of ").append(std::to_string(cells.size())).append(" values\n");
      continue;
    }
    for (const std::size_t column : layout.read) {
      records.text.append(cells[column]) += kUnitSeparator;
    }
    records.text.back() = '\n';
  }
  records.note =
      "raw data as EthoVision exports them: the animal is where its center is, and times count "
      "from the beginning of the trial";
  records.description = "raw data of EthoVision";
  records.of_animals = true;
  records.animal = layout.subject;
  if (!layout.trial.empty()) {
    records.trial = "trial " + excerpt(layout.trial) +
                    (layout.began.empty() ? "" : " of " + excerpt(layout.began));
  }
  if (!layout.arena.empty()) records.arena = "arena " + excerpt(layout.arena);
  return records;
}

}  // namespace

bool is_ethovision_table(std::string_view text) {
  return ethovision_layout(text).has_value();
}

std::optional<Error> read_ethovision_table(std::string_view text, const std::string& stem,
                                           RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  const auto layout = ethovision_layout(text);
  if (!layout) return Error{ErrorCode::kUnsupportedFormat, "these are no raw data", {}};
  return read_long_records(records_of_trial(text, *layout), stem, assembly);
}

}  // namespace beespace::io
