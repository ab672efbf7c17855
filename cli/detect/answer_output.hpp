// The answer of detect in each form that it can be asked for.
//
// Everything goes to `output` in large blocks; whether it arrived is known at its commit().
#pragma once

#include "cli/detect/answer_ids.hpp"
#include "cli/detect/detection.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/json/json_writer.hpp"

#include <string>

namespace beespace::cli {

struct Answer {
  const DetectRequest& request;
  const Inputs& inputs;
  const Detection& detection;
  const AnswerIds& ids;
};

// A line for each row, tabs between the values; ids and lists of ids likewise.
void write_text(const Answer& answer, io::AtomicOutput& output);

// Of bees the records as they stood in the input, in their own delimiter, under their header line,
// with a column more for each value; of pairs a table of ids in that delimiter.
void write_csv(const Answer& answer, io::AtomicOutput& output);

// One document: what was read, what was asked, what was found.
void write_json(const Answer& answer, io::AtomicOutput& output);

// Who is how far from whom, as members of an object.
void write_pair(io::JsonWriter& json, const Pair& pair, const Inputs& inputs, const AnswerIds& ids);

// RFC 7946: a point for every bee, a line for every pair; longitude, latitude, height as in the
// input, which must be geographic. Longitudes beyond half a turn are written within it.
void write_geojson(const Answer& answer, io::AtomicOutput& output);

}  // namespace beespace::cli
