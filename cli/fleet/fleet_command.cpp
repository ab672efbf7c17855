#include "cli/fleet/fleet_command.hpp"

#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/tracking_figures.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/fleet/fleet_output.hpp"
#include "cli/fleet/fleet_summary.hpp"
#include "cli/fleet/set_beside_flown.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/output_file.hpp"
#include "io/load_recording.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

Status check_compared(const SetBesideFlown& both, const analysis::TrackingFigures& figures) {
  if (figures.fixes > 0) return std::monostate{};
  return Error{ErrorCode::kUnsupportedFormat,
               both.bees.empty() ? "no bee was both set and flown: their ids differ"
                                 : "nothing was set at the times of flown fixes; bring both to the "
                                   "same clock, or say with --set-begins when 0 s of what was set "
                                   "was by that of what was flown",
               {}};
}

// Of what was set other columns are chosen by another option.
Error in_words_of_set(Error error) {
  constexpr std::string_view kColumns = "--columns";
  constexpr std::string_view kSetColumns = "--set-columns";
  for (std::size_t at = error.message.find(kColumns); at != std::string::npos;
       at = error.message.find(kColumns, at + kSetColumns.size())) {
    error.message.replace(at, kColumns.size(), kSetColumns);
  }
  return error;
}

std::string summary_of(const FleetRequest& request, const io::Recording& flown,
                       const io::Recording& set, const SetBesideFlown& both) {
  MovingRequest of_set = request.moving;
  of_set.inputs = {request.set};
  std::string text = input_summary(flown, request.moving) + input_summary(set, of_set);
  for (const std::string& note : both.notes) append_summary_line(text, "note", printable(note));
  return text;
}

}  // namespace

Result<ExitCode> run_fleet(const FleetRequest& request) {
  std::vector<std::string> inputs = request.moving.inputs;
  inputs.push_back(request.set);
  auto output = open_output("fleet", request.moving.output, inputs, request.moving.form.packing);
  if (!output) return std::move(output).error();
  io::RecordingOptions load = request.moving.load;
  load.one_of_several = true;
  const auto flown = io::load_recording(request.moving.inputs, load);
  if (!flown) return flown.error();
  if (!request.set_columns.empty()) load.columns = request.set_columns;
  const auto set = io::load_recording({request.set}, load);
  if (!set) return in_words_of_set(set.error());
  if (!request.set_columns.empty() && set->show && !set->format_description.starts_with("text")) {
    return Error{ErrorCode::kInvalidArgument,
                 "--set-columns is for tables, but '" + request.set + "' is none; leave it out",
                 {}};
  }
  const MaxGaps max_gaps{analysis::max_gap_of(*flown, request.max_gap_s),
                         analysis::max_gap_of(*set, request.max_gap_s)};
  const auto both = set_beside_flown(*flown, *set, request.beside, max_gaps);
  if (!both) return both.error();
  const analysis::TrackingFigures figures =
      analysis::tracking_figures(both->bees, max_gaps.set.seconds);
  if (Status compared = check_compared(*both, figures); !compared) return compared.error();
  const FleetAnswer answer{*both, figures, *flown, *set, request.max_deviation_m};
  write_answer(
      fleet_rows(answer), request.moving,
      [&answer](io::JsonWriter& json) { write_figures(json, answer); }, "each", *output);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  if (!request.moving.quiet) {
    say(summary_of(request, *flown, *set, *both) + fleet_summary(answer));
  }
  const bool risk = !bees_too_far(answer).empty() || !is_known(answer);
  return request.moving.fail_on_risk && risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
