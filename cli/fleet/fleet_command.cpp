#include "cli/fleet/fleet_command.hpp"

#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/tracking_figures.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/fleet/fleet_output.hpp"
#include "cli/fleet/set_beside_flown.hpp"
#include "cli/input/moving_output.hpp"
#include "io/load_recording.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

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
  const analysis::MaxGap max_gap = analysis::max_gap_of(*set, request.max_gap_s);
  const auto both = set_beside_flown(*flown, *set, request.beside, max_gap.seconds);
  if (!both) return both.error();
  const analysis::TrackingFigures figures = analysis::tracking_figures(both->bees, max_gap.seconds);
  if (Status compared = check_compared(*both, figures); !compared) return compared.error();
  const FleetAnswer answer{*both, figures, *flown};
  const ExitCode written = print(request.moving.json ? fleet_json(answer) : fleet_text(answer));
  if (written != ExitCode::kFine || request.moving.quiet) return written;
  say(summary_of(request, *flown, *set, *both));
  return written;
}

}  // namespace beespace::cli
