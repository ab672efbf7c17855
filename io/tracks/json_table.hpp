// A table of fixes written as JSON -> the bees of a recording. The keys are the words that tables
// have as columns.
//
// As pandas writes it:
// - records: a list of objects, [{"timestamp": ..., "icao24": ...}, ...], and the same in "data"
//   beside a "schema";
// - columns: {"timestamp": {"0": ..., "1": ...}, "icao24": {...}}, or with lists;
// - index: {"0": {"timestamp": ...}, "1": {...}};
// - split: {"columns": [...], "data": [[...], ...]};
// - lines: an object a line.
//
// Where no column is an id, the keys of the rows are (of split its "index"), unless they only
// number them.
#pragma once

#include "io/json/json_document.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// Whether a document has one of these forms and names a position.
bool is_json_table(JsonElement root);

// Whether the text is one object a line, and more than one.
bool is_json_lines(std::string_view text);

// Into the source that `assembly` has begun; `stem` is the bee where there is no id. Errors have
// the record, or the line.
std::optional<Error> read_json_table(JsonElement root, const std::string& stem,
                                     RecordingAssembly& assembly);
std::optional<Error> read_json_lines(std::string_view text, const std::string& stem,
                                     RecordingAssembly& assembly);

}  // namespace beespace::io
