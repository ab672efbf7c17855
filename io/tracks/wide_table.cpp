#include "io/tracks/wide_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/long_records.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// Where an animal's coordinates are.
struct AnimalColumns {
  std::string number;
  std::size_t x;
  std::size_t y;
};

struct WideLayout {
  TableLayout table;
  std::optional<std::size_t> time;  // none: rows are frames
  std::vector<AnimalColumns> animals;
  std::size_t ends = 0;  // behind the last column of theirs
  bool with_probabilities = false;
};

// "12" of "x12", where the letter is that; of AnimalTA "Arena0_Ind1" of "X_Arena0_Ind1".
std::string number_behind(char letter, std::string_view name) {
  constexpr std::string_view kArena = "_arena";
  const std::string lower = lower_case(without_padding(name));
  if (lower.size() < 2 || lower.front() != letter) return {};
  std::string behind = lower.substr(1);
  const auto begins = [&behind](std::size_t at) {
    return behind.find_first_not_of("0123456789", at);
  };
  if (begins(0) == std::string::npos) return behind;
  if (!behind.starts_with(kArena)) return {};
  const std::size_t individual = begins(kArena.size());
  constexpr std::string_view kIndividual = "_ind";
  const bool known = individual != kArena.size() && individual != std::string::npos &&
                     behind.compare(individual, kIndividual.size(), kIndividual) == 0 &&
                     behind.size() > individual + kIndividual.size() &&
                     begins(individual + kIndividual.size()) == std::string::npos;
  return known ? std::string(without_padding(name).substr(2)) : std::string();
}

// idTracker tells beside each how sure it is of the animal: "ProbId12".
bool is_probability_of(std::string_view number, std::string_view name) {
  constexpr std::string_view kProbability = "probid";
  const std::string lower = lower_case(without_padding(name));
  return lower.starts_with(kProbability) && lower.substr(kProbability.size()) == number;
}

// UMATracker calls the number of the picture "position".
bool counts_pictures(std::string_view name) {
  return read_column_name(track_columns(), name).role == Role::kFrame ||
         lower_case(without_padding(name)) == "position";
}

std::optional<WideLayout> wide_layout(std::string_view text) {
  auto table = find_table(text, false);
  if (!table || table->names.size() < 4) return std::nullopt;
  WideLayout wide{*std::move(table), std::nullopt, {}};
  const std::vector<std::string>& names = wide.table.names;
  // A time, or the number of the picture, or both.
  std::size_t first = 0;
  while (first < 2 && number_behind('x', names[first]).empty()) {
    const bool time = read_column_name(track_columns(), names[first]).role == Role::kTime;
    if (!time && !counts_pictures(names[first])) return std::nullopt;
    if (!wide.time || time) wide.time = first;
    ++first;
  }
  for (std::size_t i = first; i + 1 < names.size(); i += 2) {
    std::string number = number_behind('x', names[i]);
    if (number.empty() || number != number_behind('y', names[i + 1])) return std::nullopt;
    wide.animals.push_back({number, i, i + 1});
    wide.ends = i + 2;
    if (wide.ends < names.size() && is_probability_of(number, names[wide.ends])) {
      wide.with_probabilities = true;
      ++wide.ends;
      ++i;
    }
  }
  if (wide.ends != names.size() || wide.animals.size() < 2) return std::nullopt;
  return wide;
}

// The same as a table with a record for each animal in each row; rows that are too short or long
// are left as they are, so that who reads it says so.
std::string long_text(std::string_view text, const WideLayout& wide) {
  std::string out;
  out.reserve(2 * text.size());
  std::vector<std::string_view> fields;
  std::size_t frame = 0;
  std::uint64_t lines = 0;
  RecordWalk walk(text, wide.table.data_offset, wide.table);
  while (walk.next()) {
    // Blank lines count, as many for each as there are animals.
    out.append((walk.line() - lines) * wide.animals.size(), '\n');
    lines = walk.line() + 1;
    fields.clear();
    FieldCursor cursor(walk.record(), wide.table.delimiter);
    for (Field field; cursor.next(field);) fields.push_back(without_padding(field.text));
    const std::string row = std::to_string(frame++);
    const bool whole = fields.size() == wide.table.columns && cursor.problem().empty();
    for (const AnimalColumns& animal : wide.animals) {
      if (!whole) {
        out.append("a row of ").append(std::to_string(fields.size())).append(" values\n");
        continue;
      }
      const std::string_view time = wide.time ? fields[*wide.time] : std::string_view(row);
      for (const std::string_view field :
           {time, std::string_view(animal.number), fields[animal.x], fields[animal.y]}) {
        out.append(field) += kUnitSeparator;
      }
      out.back() = '\n';
    }
  }
  return out;
}

}  // namespace

bool is_wide_table(std::string_view text) {
  return wide_layout(text).has_value();
}

std::optional<Error> read_wide_table(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  const auto wide = wide_layout(text);
  if (!wide) return Error{ErrorCode::kUnsupportedFormat, "this is no table of animals", {}};
  if (auto error = no_record_problem(text, wide->table)) return error;
  LongRecords records;
  records.text = long_text(text, *wide);
  const bool pictures = !wide->time || counts_pictures(wide->table.names[*wide->time]);
  records.names = {pictures ? "frame" : wide->table.names[*wide->time], "id", "x", "y"};
  // idtracker.ai and AnimalTA count seconds.
  const std::string time = lower_case(without_padding(records.names.front()));
  const bool unsaid = assembly.options().time_unit == Unit::kUnstated;
  if (time == "time" && unsaid) records.names.front() = "time_s";
  records.lines_before = wide->table.lines_before;
  records.per_line = wide->animals.size();
  const bool of_animalta = wide->animals.front().number.starts_with("Arena");
  const char* const written_by = of_animalta                ? "AnimalTA"
                                 : wide->with_probabilities ? "idTracker"
                                                            : "idtracker.ai";
  records.note = "columns of " + std::to_string(wide->animals.size()) +
                 " animals stand beside each other, as " + written_by + " writes them" +
                 (wide->time ? "" : "; there is no time: rows are taken for frames");
  records.description = "text, columns for each animal";
  records.of_animals = true;
  return read_long_records(records, {}, assembly);
}

}  // namespace beespace::io
