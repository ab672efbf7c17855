#include "io/tracks/long_records.hpp"

#include "io/problems/skipped_records.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"
#include "io/tracks/video_units.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

TableLayout table_of(const LongRecords& records) {
  TableLayout table;
  table.delimiter = kUnitSeparator;
  table.names = records.names;
  table.columns = table.names.size();
  for (const std::string& name : table.names) {
    table.contents.push_back(name == "id" ? ColumnContent::kText : ColumnContent::kNumber);
  }
  table.lines_before = records.lines_before;
  table.records_per_line = records.per_line;
  return table;
}

// The names of these columns are not in the file.
void leave_names_out(const LongRecords& records, TrackLayout& layout) {
  std::erase_if(layout.notes, [](const std::string& note) {
    return note.find(" read from column ") != std::string::npos;
  });
  for (UnitTaken& unit : layout.units) {
    if (unit.evidence == UnitEvidence::kNamed) unit.reason = records.unit_reason;
  }
}

// A row of the file with fewer values, or more, than it has columns is written as a record of one
// cell that says how many.
Error of_row(Error error) {
  constexpr std::string_view kBegins = "'a row of ";
  constexpr std::string_view kEnds = " values'";
  const std::size_t begins = error.message.find(kBegins);
  if (begins == std::string::npos) return error;
  const std::size_t at = begins + kBegins.size();
  const std::size_t ends = error.message.find(kEnds, at);
  if (ends == std::string::npos) return error;
  error.message = "this row has another number of values than the table has columns, " +
                  error.message.substr(at, ends - at) +
                  ", as where a file was cut off while it was written; correct it" +
                  std::string(kOrLeaveOut);
  return error;
}

}  // namespace

std::optional<Error> read_long_records(const LongRecords& records, const std::string& stem,
                                       RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  if (records.text.empty()) {
    return Error{ErrorCode::kNoPoints, "there are rows that name columns and none after them", {}};
  }
  if (options.progress != nullptr) options.progress->total += records.text.size();
  auto layout = choose_track_layout(table_of(records), records.text, options, SeenRecords::kWhole);
  if (!layout) {
    Error error = std::move(layout).error();
    error.location.column.reset();
    return error;
  }
  if (auto error = lengths_problem(layout->table, options)) return error;
  if (!records.unit_reason.empty()) leave_names_out(records, *layout);
  assembly.note(records.note);
  SourceFacts facts = facts_of(*layout, records.description);
  facts.of_animals = facts.of_animals || records.of_animals;
  facts.trial = records.trial;
  facts.arena = records.arena;
  if (auto error = assembly.agree(facts)) return error;
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  const bool named = layout->table.choice.id.has_value();
  // Of several arenas each may have a "Subject 1".
  const bool says_whose = !records.animal.empty() && !assembly.is_taken(records.animal);
  if (!named && !says_whose) {
    assembly.note("there is no id: each file is taken for one bee, named after it");
  }
  RecordsBefore none;
  auto error = read_track_records(
      records.text, *layout,
      named ? std::string() : assembly.name_of_source(says_whose ? records.animal : stem),
      RecordPlace::kLineAndName, none, assembly);
  if (error) return of_row(*std::move(error));
  return std::nullopt;
}

}  // namespace beespace::io
