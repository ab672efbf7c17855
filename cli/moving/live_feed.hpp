// Reports in the order in which they arrive, events in the order in which they become known: the
// same for `watch` and for `replay --report events`.
//
// The swarm is looked at every so often by the clock of the reports, not by that of the wall, so
// the same reports give the same events however fast they come. A look is taken once a report of a
// later time comes: then those of its own time are in.
#pragma once

#include "cli/moving/look_times.hpp"
#include "cli/moving/rows.hpp"

#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::cli {

class LiveFeed {
 public:
  // Sees the events of each look, if there are any, ascending in time.
  using Tell = std::function<void(const std::vector<SwarmEvent>& events)>;

  LiveFeed(const SwarmOptions& options, double every_s, Tell tell);

  // Sees the time of each look from now on, once its events have been told. Reports of that time
  // are in, and of later times none but those of clocks that are ahead; at the end of the input,
  // or where nothing comes for a while, a look may be at any time, and at the time of the one
  // before.
  using Looked = std::function<void(double time_s)>;
  void after_each_look(Looked looked) { looked_ = std::move(looked); }

  // Sees each report from now on that the swarm has taken note of, late and repeated ones too.
  using Reported = std::function<void(const Report& report)>;
  void after_each_report(Reported reported) { reported_ = std::move(reported); }

  // The number of a bee, by its id. What it is called beside that is kept, if it is said.
  PointId number(std::string_view id, std::string_view label);
  [[nodiscard]] const BeeName& name(PointId number) const { return names_[number]; }

  // Takes a report, after looking at the swarm where the time of a look has passed. Times may go
  // back a little: nobody looks again. One that is far ahead of all before waits for another that
  // bears it out, or one wrong clock would make everybody else stale; otherwise it is left out.
  // Errors: as Swarm::update and Swarm::advance.
  Status take(const Report& report);

  // Nothing has come for so long: looks, as if the clock of the reports went on like ours.
  Status idle(double for_s);

  // The last look, at the time of the last report; what it ends is told.
  Status finish();

  // Everybody at a time, by numbers: as Swarm::movers.
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const { return swarm_.movers(time_s); }
  [[nodiscard]] SwarmCounts counts() const { return ended_with_.value_or(swarm_.counts()); }
  // How many reports were left out because they were far ahead.
  [[nodiscard]] std::uint64_t ahead() const { return ahead_; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };

  Status look(double time_s);
  Status pass_on(const Report& report);

  Swarm swarm_;
  LookTimes times_;
  Tell tell_;
  Looked looked_;
  Reported reported_;
  std::optional<std::int64_t> looks_;  // the number of the last
  std::optional<double> latest_s_;     // of all reports
  std::optional<Report> waiting_;      // far ahead of these
  std::uint64_t ahead_ = 0;
  std::optional<SwarmCounts> ended_with_;  // at the end
  double looked_s_ = -std::numeric_limits<double>::infinity();
  double idle_s_ = 0.0;  // since the last report
  std::unordered_map<std::string, PointId, Hash, std::equal_to<>> numbers_;
  std::vector<BeeName> names_;
};

// A line of JSON, with its end.
std::string event_line(const SwarmEvent& event, const LiveFeed& feed);

// "predicted", "possible", "heard", "entered", "closest_passed", "left", "stale", "lost", "ended",
// "overloaded".
const char* name_of(EventKind kind);
// "bees", "pairs", "predicted", "possible".
const char* name_of(SwarmBound bound);

}  // namespace beespace::cli
