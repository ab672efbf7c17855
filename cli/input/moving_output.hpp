// What `predict` and `replay` both say: the input on the summary's lines and in the JSON document,
// conflicts as rows, and the answer written where it is wanted.
#pragma once

#include "cli/console/summary_line.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/output/rows.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// What positions are in, and why where that is known; what heights are counted from.
void append_frame_lines(std::string& out, io::Frame frame, const std::string& reason,
                        io::HeightDatum heights);

// The lines about what was read.
std::string input_summary(const io::Recording& recording, const MovingRequest& request);

// "5 m (closer than), as the show declares".
std::string separation_summary(const MovingRequest& request, double threshold_m, bool declared);

// "drone_01 and drone_02"; "drone_01 and drone_02, 4.31 m apart at 63.2 s".
std::string pair_text(const Conflict& conflict, const io::Recording& recording);
std::string encounter_text(const Conflict& conflict, const io::Recording& recording);

// first, second, begins_s, closest_s, closest_m, ends_s; and certain, where there are tolerances.
Rows conflict_rows(const std::vector<Conflict>& conflicts, const io::Recording& recording,
                   bool with_certain);

// The first members of the JSON document, up to and with the separation.
void write_head(io::JsonWriter& json, const io::Recording& recording, const MovingRequest& request,
                double threshold_m);

// Writes the rows in the form wished for; in JSON under `key`, behind the members of `head`.
using JsonHead = std::function<void(io::JsonWriter&)>;
void write_answer(Rows rows, const MovingRequest& request, const JsonHead& head, const char* key,
                  io::AtomicOutput& output);

}  // namespace beespace::cli
