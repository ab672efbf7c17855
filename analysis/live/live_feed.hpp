// Reports in the order in which they arrive, events in the order in which they become known: the
// same for `watch` and for `replay --report events`.
//
// The swarm is looked at every so often by the clock of the reports, so the same reports give the
// same events however fast they come. A look is taken once a report of a later time comes: then
// those of its own time are in. Live, time goes on by the wall while nothing comes that moves it,
// and looks are taken so too. Whose clock is believed: bee_clocks.hpp.
#pragma once

#include "analysis/live/bee_clocks.hpp"
#include "analysis/live/clock_lags.hpp"
#include "analysis/live/look_times.hpp"
#include "analysis/live/report_intervals.hpp"
#include "analysis/text/bee_name.hpp"

#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::analysis {

// What is said of clocks beside the events.
struct ClockNote {
  enum class Kind : std::uint8_t {
    kOff,    // that of a bee is ahead by ahead_s (behind, where that is negative)
    kApart,  // the same, by so little that it is believed
    kRight,  // and is right again
    kAnew,   // those of all have begun anew: at time_s, after before_s
  };
  Kind kind;
  double time_s;
  AgentId bee;
  double ahead_s;
  double before_s;
};

struct LiveTimes {
  double look_every_s;
  double max_skew_s;
};

class LiveFeed {
 public:
  // Sees the events of each look, if there are any, ascending in time.
  using Tell = std::function<void(const std::vector<SwarmEvent>& events)>;

  LiveFeed(const SwarmOptions& options, const LiveTimes& times, Tell tell);

  // Sees the time of each look from now on, once its events have been told. Reports of that time
  // are in, and of later times none but those of clocks that are ahead; at the end of the input,
  // or where nothing comes for a while, a look may be at any time, and at the time of the one
  // before.
  using Looked = std::function<void(double time_s)>;
  void after_each_look(Looked looked) { looked_ = std::move(looked); }

  // Sees each report that has been taken, at the time at which it was.
  // `now_s`: the time of the swarm, which the time of a corrected report may be ahead of.
  using Reported = std::function<void(const PositionReport& report, double now_s)>;
  void after_each_report(Reported reported) { reported_ = std::move(reported); }

  // Sees what is said of clocks.
  using Noted = std::function<void(const ClockNote& note)>;
  void after_each_note(Noted note) { note_ = std::move(note); }

  // Sees each report that was not taken as its bee is elsewhere at that time already.
  using Contrary = std::function<void(const PositionReport& report)>;
  void after_each_contrary(Contrary contrary) { contrary_ = std::move(contrary); }

  // The number of a bee, by its id; nothing where there are too many. What it is called beside
  // that is kept, if it is said.
  std::optional<AgentId> number(std::string_view id, std::string_view label);
  [[nodiscard]] const BeeName& name(AgentId number) const { return names_[number]; }
  // The time of the last look, whose events are told.
  [[nodiscard]] double looked_s() const { return looked_s_; }
  // How many bees have been heard of, those that have left among them.
  [[nodiscard]] std::size_t heard_of() const { return names_.size(); }
  // The same of one that has a number already.
  [[nodiscard]] std::optional<AgentId> known(std::string_view id) const;

  // What is wrong where there are too many; it is told at the next look.
  Error too_many();

  // Takes a report, after looking at the swarm where the time of a look has passed. `wall_s` is
  // when it came, by a clock that never goes back; 0 always where that is of no account. Errors: as
  // Swarm::update and Swarm::advance, also of reports that were kept back until now.
  Status take(const PositionReport& report, double wall_s = 0.0);

  // A bee that is there no longer: which, if it is known.
  std::optional<AgentId> leave(std::string_view id);

  // Looks where the time of a look has passed by the wall, and a little more, so that reports of
  // that time are in.
  Status look_if_due(double wall_s);
  // How long until then, a second at most.
  [[nodiscard]] double next_look_in_s(double wall_s) const;

  // What was kept back, and the last look, at the time of the last report; what it ends is told.
  Status finish();

  // All bees at a time, by numbers: as Swarm::movers.
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const { return swarm_.movers(time_s); }
  // Until the end, and from then on those of the end.
  [[nodiscard]] SwarmCounts counts() const { return ended_with_.value_or(swarm_.counts()); }
  // Bees that were unknown for a time: once it has ended.
  [[nodiscard]] const std::vector<Silence>& silences() const { return silences_; }
  // Once it has ended: how many bees, not stale yet and not gone, were last heard of earlier than
  // their reports come as a rule. Where they were from then on is not known.
  [[nodiscard]] std::size_t silent_at_the_end() const { return silent_at_the_end_; }
  [[nodiscard]] const BeeClocks& clocks() const { return clocks_; }
  // How many bees were found whose clocks differ by so little that they are believed.
  [[nodiscard]] std::uint64_t apart() const { return lags_.named(); }
  // Of a bee that was first heard of so late, or again after a silence, that others were already
  // forgotten where they had been then: nothing was compared with it until so much later.
  struct Missed {
    std::string id;  // numbers of bees that have left become others'
    double lasted_s;
  };
  // How often that was by more than half a second, and the longest.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }
  [[nodiscard]] const Missed& longest_missed() const { return longest_missed_; }
  // How often all clocks began anew.
  [[nodiscard]] std::uint64_t begun_anew() const { return begun_anew_; }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  static constexpr double kGrace_s = 0.25;
  static constexpr double kLongestWait_s = 1.0;

  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };

  struct Leaving {
    double at_s;
    AgentId bee;
  };

  bool told_lately(const SwarmEvent& event);
  std::optional<AgentId> look_up(std::string_view id);
  void free_numbers();
  Status follow();
  void compare_clocks(const PositionReport& report);
  void note(const ClockNote& note);
  Status look_before(double now_s);
  Status pass_on(const PositionReport& report, double now_s);
  void note_missed(AgentId bee, double lasted_s);
  Status go_back(double now_s, bool anew);
  Status look(double time_s);
  Status end(std::optional<double> anew_s = {});

  Swarm swarm_;
  double max_age_s_;
  std::size_t max_bees_;
  LookTimes times_;
  BeeClocks clocks_;
  std::vector<BeeClocks::Step> steps_;
  ClockLags lags_;
  std::vector<ClockLags::Told> apart_;
  Tell tell_;
  Looked looked_;
  Reported reported_;
  Contrary contrary_;
  Noted note_;
  std::optional<std::int64_t> looks_;      // the number of the last
  double next_look_s_ = kNever;            // when the next is
  std::optional<double> latest_s_;         // the time of the swarm at the last report
  std::optional<SwarmCounts> ended_with_;  // at the end
  std::vector<Silence> silences_;          // at the end
  std::size_t silent_at_the_end_ = 0;
  ReportIntervals intervals_;
  double looked_s_ = -std::numeric_limits<double>::infinity();
  std::array<double, kSwarmBounds> overloaded_s_;  // by bound: when it was last reported
  double not_before_s_ = 0.0;  // by the wall: the next look that no report brings
  std::uint64_t begun_anew_ = 0;
  std::uint64_t missed_ = 0;
  Missed longest_missed_ = {{}, 0.0};
  std::unordered_map<std::string, AgentId, Hash, std::equal_to<>> numbers_;
  std::vector<BeeName> names_;
  std::vector<AgentId> follows_;   // by number: who came after it the last time
  std::vector<double> left_at_s_;  // by number: and has not come back
  std::vector<AgentId> free_;      // numbers
  std::deque<Leaving> leaving_;
  AgentId named_last_ = 0;
  std::uint64_t refused_ = 0;  // reports of bees beyond the bound since the last look
};

}  // namespace beespace::analysis
