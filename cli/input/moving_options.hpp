// What `predict` and `replay` are both told: what to read, how close is too close, where the answer
// goes.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "cli/command_line/command.hpp"
#include "cli/output/output_form.hpp"
#include "cli/output/rows.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// As typed, before it is checked.
struct MovingOptions {
  std::vector<std::string> inputs;
  std::string frame = "auto";
  std::string columns;
  std::string time_unit = "auto";
  std::string units;
  std::string heights = "auto";
  std::string threshold;  // empty: what the input declares, or 100
  std::string vertical;
  std::string max_results;
  std::string threads = "0";
  std::string output = "-";
  bool inclusive = false;
  bool grounded = false;
  bool skip_bad = false;
  bool csv = false;
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

using analysis::kDefaultThreshold_m;

// Checked: a request that makes sense.
struct MovingRequest {
  const char* command;
  std::vector<std::string> inputs;
  io::RecordingOptions load;
  std::optional<double> threshold_m;  // absent: what the input declares, or the default
  std::optional<double> vertical_m;
  std::optional<io::StatedLength> vertical;  // the same, as typed
  bool inclusive = false;
  std::uint64_t max_results = 0;
  unsigned threads = 0;
  std::string output;
  OutputForm form;
  bool fail_on_risk = false;
  bool quiet = false;
};

// Of `predict`, `replay` and `watch`, which find the same.
inline constexpr const char* kVerticalHelp =
    "Too close only if closer than this in height too;\n"
    "the threshold is then horizontal. Of degrees, the\n"
    "distance shown is then hypot(ground, height)";

// How to read, as `predict`, `replay` and `watch` are told alike.
struct ReadingOptions {
  const std::string& frame;
  const std::string& time_unit;
  const std::string& columns;
  const std::string& heights;
  const std::string& units;
};
// Errors: kInvalidArgument for units that are none.
Result<io::RecordingOptions> recording_options(const char* command, const ReadingOptions& options);
// --units and --heights.
void add_units_options(Command& command, std::string& units, std::string& heights);

void add_input_options(Command& command, MovingOptions& options);
// Of recordings. As typed it is nothing, "never" (infinite), or seconds above zero.
void add_max_gap_option(Command& command, std::string& max_gap, const char* group);
Result<std::optional<double>> read_max_gap(const char* command, const std::string& text);
// That, and --tolerance.
void add_gap_options(Command& command, std::string& max_gap, std::string& tolerance);
void add_threshold_options(Command& command, MovingOptions& options);
// The same, and how many conflicts there may be.
void add_separation_options(Command& command, MovingOptions& options);
void add_output_options(Command& command, MovingOptions& options);

Result<MovingRequest> moving_request(const char* command, const MovingOptions& options);

// The same of a command that answers in text, CSV or JSON. `text_endings`: how the names of files
// end that hold its plain text.
Result<MovingRequest> answering_request(const char* command, const MovingOptions& options,
                                        const std::vector<std::string>& text_endings = {"tsv"});

// The library speaks to those who call it; here --max-results is what they can turn.
Error in_words_of_the_command(Error error, const MovingRequest& request);

}  // namespace beespace::cli
