// What `predict` and `replay` are both told: what to read, how close is too close, where the answer
// goes.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "cli/input/separation.hpp"
#include "cli/output/output_form.hpp"
#include "cli/output/rows.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

class Command;

using analysis::kDefaultThreshold_m;

struct MovingRequest {
  const char* command = "";
  std::vector<std::string> inputs = {};
  io::RecordingOptions load = {};
  std::optional<double> threshold_m = {};  // absent: what the input declares, or the default
  std::optional<io::StatedLength> threshold = {};  // the same, as typed
  std::optional<double> vertical_m = {};
  std::optional<io::StatedLength> vertical = {};  // the same, as typed
  const UsualSeparation* separation = nullptr;    // that stands for both
  bool inclusive = false;
  std::optional<double> ignore_below_m = {};  // see analysis/recorded/low_conflicts.hpp
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();
  unsigned threads = 0;
  std::string output = "-";
  bool csv = false;
  bool json = false;
  OutputForm form = {};  // that these three ask for
  bool fail_on_risk = false;
  bool quiet = false;
};

// Of `predict`, `replay` and `watch`, which find the same.
inline constexpr const char* kVerticalHelp =
    "Too close only if closer than this in height too;\n"
    "the threshold is then horizontal. Of degrees, the\n"
    "distance shown is then hypot(ground, height)";

// How to read: --crs, --time-unit, --units and --heights.
void add_frame_option(Command& command, io::Frame& frame, const char* help);
void add_time_unit_option(Command& command, io::Unit& unit);
// --time-zone, --dates, --fps and --scale.
void add_clock_and_pixel_options(Command& command, io::RecordingOptions& load);
void add_units_options(Command& command, io::UnitOverrides& units, io::HeightSource& heights);

void add_input_options(Command& command, MovingRequest& request);
// Of recordings: --max-gap; and that with --tolerance.
void add_max_gap_option(Command& command, std::optional<double>& max_gap_s);
void add_gap_options(Command& command, std::optional<double>& max_gap_s, double& tolerance_m);
// --sector, of commands that ask about a recording, and not whether a flight was good.
void add_sector_option(Command& command, io::RecordingOptions& load);
void add_threshold_options(Command& command, MovingRequest& request);
// --ignore-below, of commands that know where bees took off.
void add_low_option(Command& command, MovingRequest& request);
// The same, and how many conflicts there may be.
void add_separation_options(Command& command, MovingRequest& request);
// Where the answer goes, and in which form.
void add_form_options(Command& command, MovingRequest& request);
void add_risk_option(Command& command, MovingRequest& request);
void add_quiet_option(Command& command, bool& quiet);

// What no option says alone, once all are read. Errors: kInvalidArgument.
Status settle(MovingRequest& request, const char* command);
// The same of a command that answers in text, CSV or JSON. `text_endings`: how the names of files
// end that hold its plain text.
Status settle_answer(MovingRequest& request, const char* command,
                     const std::vector<std::string>& text_endings = {"tsv"});

// The library speaks to those who call it; here --max-results is what they can turn.
Error in_words_of_the_command(Error error, const MovingRequest& request);

}  // namespace beespace::cli
