#include "io/tracks/long_records.hpp"

#include "io/table/table_layout.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"
#include "io/tracks/video_units.hpp"

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
  return read_track_records(
      records.text, *layout,
      named ? std::string() : assembly.name_of_source(says_whose ? records.animal : stem),
      RecordPlace::kLineAndName, none, assembly);
}

}  // namespace beespace::io
