// What a JSON document says besides the answer.
#pragma once

#include "cli/detect/detection.hpp"
#include "io/json/json_writer.hpp"

namespace beespace::cli {

// Behind a key.
void write_input(io::JsonWriter& json, const InputFacts& facts);

// Members: ids that come again.
void write_repeated(io::JsonWriter& json, const io::RepeatedIds& repeated);

// Members: what was asked, and how long it took. `height_unit` is that of all heights.
void write_search(io::JsonWriter& json, const DetectRequest& request, io::Unit height_unit);
void write_timings(io::JsonWriter& json, const Timings& timings);

}  // namespace beespace::cli
