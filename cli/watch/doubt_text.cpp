#include "cli/watch/doubt_text.hpp"

#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

namespace beespace::cli {
namespace {

std::string jumps_in(const std::string& bee, const std::string& line, double time_s) {
  return "beespace: " + printable(bee) + " jumps in " + line + ", " + io::exact(time_s) + " s, ";
}

}  // namespace

std::string jump_text(const std::string& bee, const std::string& line, double time_s) {
  return jumps_in(bee, line, time_s) +
         "faster than anything that flies, than it says itself, "
         "or, there and back, than it ever moves elsewhere: a place or a time is wrong\n";
}

std::string thawed_text(const std::string& bee, const std::string& line, double time_s) {
  return jumps_in(bee, line, time_s) +
         "more than three times as far and as fast as before, out of a place that it had repeated "
         "exactly: where it was meanwhile is not known\n";
}

std::string shared_text(const std::string& bee, const std::string& line, double time_s) {
  return "beespace: " + printable(bee) + " is at two places in turn, up to " + line + ", " +
         io::exact(time_s) +
         " s, as if two or more had this id: where they are is not known; give each its own\n";
}

std::string contrary_text(const std::string& bee, double time_s) {
  return "beespace: left out: " + printable(bee) + " is said to be at two places at " +
         io::exact(time_s) + " s; the first one counts\n";
}

Error own_clocks_problem(const std::string& first, const io::ReportLine& second, bool live) {
  const std::string arrival = live ? "take the time at which each report comes, --clock arrival"
                                   : "of reports as they come, not of a file, take the time at "
                                     "which each comes, --clock arrival";
  return {ErrorCode::kInvalidArgument,
          io::excerpt(second.own_clock) +
              " counts from when each vehicle was switched on, but here are several (" +
              io::excerpt(first) + ", " + io::excerpt(second.id) +
              "): then they cannot be compared; use a time of one clock, or " + arrival +
              ", or, if these have one clock, say so with --one-clock",
          {}};
}

Error none_understood(const std::vector<Error>& errors) {
  Error error = errors.front();
  if (errors.size() > 1) {
    error.message +=
        " (and none of the next " + std::to_string(errors.size() - 1) + " lines could be read)";
  }
  return error;
}

}  // namespace beespace::cli
