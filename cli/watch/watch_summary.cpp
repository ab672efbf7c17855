#include "cli/watch/watch_summary.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/input/separation.hpp"
#include "io/bytes/number_text.hpp"

namespace beespace::cli {
namespace {

void append_advice_counts(std::string& out, const WatchFacts& facts) {
  const LiveAdvice& advice = *facts.advice;
  std::string text = io::grouped(advice.told());
  if (advice.uncertified() > 0) {
    text += ", " + red(io::grouped(advice.uncertified())) + " not certified";
  }
  append_summary_line(out, "advice", text);
  const std::uint64_t without = facts.unadvised_looks + advice.skipped();
  if (without == 0) return;
  append_summary_line(out, "no advice", red(io::grouped(without)) + " looks");
}

}  // namespace

std::string watch_summary(const WatchFacts& facts) {
  const WatchRequest& request = facts.request;
  const LeftOutOfWatch& left_out = facts.left_out;
  std::string out;
  append_summary_line(out, "input", printable(facts.lines.description()));
  if (facts.feed != nullptr) append_frame_lines(out, facts.frame, "", facts.lines.heights());
  append_units(out, facts.lines.units());
  append_note(out, analysis::metres_note(facts.lines.units(), facts.frame, request.threshold));
  append_vertical(out, request.vertical, facts.height_unit);
  for (const std::string& note : facts.lines.notes()) {
    append_summary_line(out, "note", printable(note));
  }
  if (facts.perhaps_frozen.bees() > 0) {
    append_note(out, facts.perhaps_frozen.text(io::exact(facts.perhaps_frozen.since_s()) + " s"));
  }
  const SwarmCounts counts = facts.feed != nullptr ? facts.feed->counts() : SwarmCounts{};
  append_summary_line(out, "reports", io::grouped(counts.taken));
  if (counts.late > 0) append_summary_line(out, "late", io::grouped(counts.late) + " left out");
  if (counts.repeated > 0) {
    append_summary_line(out, "repeated", io::grouped(counts.repeated) + " left out");
  }
  if (facts.feed != nullptr) facts.tally.append_clocks(out, *facts.feed);
  if (left_out.contrary > 0) {
    append_summary_line(out, "contrary", red(io::grouped(left_out.contrary)) + " left out");
  }
  if (left_out.lines > 0) {
    append_summary_line(out, "bad lines", red(io::grouped(left_out.lines)) + " left out");
  }
  append_summary_line(
      out, "bees",
      io::grouped(counts.agents) + " heard of, " + io::grouped(counts.stale) + " stale");
  if (facts.feed != nullptr) facts.tally.append_unknown(out, *facts.feed);
  const bool of_drones = facts.lines.in_frames() && !request.threshold;
  append_summary_line(out, "threshold",
                      separation_text(request.swarm.threshold_m, request.swarm.vertical_m, false,
                                      request.threshold, request.vertical) +
                          usual_text(request.separation) +
                          (of_drones ? ", the default of logs of drones (--threshold)" : ""));
  if (facts.feed != nullptr) facts.tally.append_events(out, *facts.feed, left_out);
  if (facts.advice != nullptr) append_advice_counts(out, facts);
  return out;
}

}  // namespace beespace::cli
