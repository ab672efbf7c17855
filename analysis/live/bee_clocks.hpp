// Whose clock is to be believed: the time of each report, judged by those of the other bees and,
// live, by the clock on the wall.
//
// The time of the swarm is that of the latest report that is believed; live it goes on with the
// wall while nothing comes. A report within `max_skew_s` of it is believed. One that is farther
// ahead is kept back until the others bear it out (time has passed for all) or contradict it (they
// go on where they were): then the clock of its bee is off. The bee is named, and from then on its
// reports are taken at their time less what its clock is ahead, which is measured again whenever
// the clock steps. Nothing comes from the future, so that is right but for how long reports take.
//
// One that is behind may be late only. It is passed on as it is if it is not older than
// `max_age_s`, and kept back otherwise; a bee that is behind for `max_age_s` together, or three
// times in a row at the end of the input, is named and corrected.
//
// Where what is passed on of a bee does not go on from what was passed on before, as reports in
// between are left out, or it is corrected by something else, kLost comes between the two.
//
// Where more than half of the bees that were heard of lately are ahead, or behind three times in a
// row (once they are late, as it happens to several at once), it is the time of the swarm that is
// wrong, and it becomes theirs; so do the clocks of bees that no other contradicts
// while their own go on for `max_age_s`. Of two bees that contradict each other it cannot be told
// which is right: the one that came later is named.
//
// Reports in the order of their times are never contradicted, and all come out as they are and in
// that order. Memory: some 80 bytes a bee, and what is kept back, at most kMostKept
// reports and some of each bee.
#pragma once

#include <beespace/swarm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace beespace::analysis {

class BeeClocks {
 public:
  struct Limits {
    double max_skew_s;
    double max_age_s;
  };
  explicit BeeClocks(const Limits& limits) : limits_(limits) {}

  static constexpr std::size_t kMostKept = std::size_t{1} << 16;

  // What follows from a report, in this order.
  struct Step {
    enum class Kind : std::uint8_t {
      kReport,  // take this one, at its time
      kLost,    // what comes next of report.id does not go on from what came before
      kOff,     // of report.id: its clock is ahead by ahead_s, or behind where that is negative
      kRight,   // its clock is right again
      kBack,    // the time of the swarm goes back to now_s
    };
    Kind kind = Kind::kReport;
    PositionReport report = {};
    double now_s = 0.0;  // the time of the swarm from now on
    double ahead_s = 0.0;
    bool anew = false;  // kBack: most clocks went back themselves
  };

  // Whether the report is to be taken as it is; otherwise `steps` gets what is to be done, if
  // anything. `wall_s` never goes back; 0 always where there is none.
  bool take(const PositionReport& report, double wall_s, std::vector<Step>& steps);

  // The end of the input: what was kept back is taken as it is.
  void finish(std::vector<Step>& steps);

  // A bee that is there no longer.
  void forget(AgentId id);

  // The time of the swarm: of the reports, and as it goes on by the wall.
  [[nodiscard]] double now() const { return now_s_; }
  [[nodiscard]] double now(double wall_s) const { return now_s_ + (wall_s - now_wall_s_); }
  [[nodiscard]] bool started() const { return started_; }

  // Reports that were left out for their times, and how many bees have been named.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
  [[nodiscard]] std::uint64_t named() const { return named_; }

 private:
  enum class Place : std::uint8_t { kNear, kAhead, kBehind };

  struct Bee {
    double last_s = -std::numeric_limits<double>::infinity();  // as reported
    double lead_s = 0.0;       // of that, to the time of the swarm then
    double offset_s = 0.0;     // what its reports are corrected by, where it is off
    double told_s = 0.0;       // the lead that it was named with
    double told_at_s = 0.0;    // by the time of the swarm
    double since_s = 0.0;      // that time when it was first found elsewhere than near
    double interval_s = 0.0;   // between its last two reports that were near; 0: not known yet
    double unopposed_s = 0.0;  // how far its own clock has gone on with no other one against it
    std::uint64_t nears = 0;   // nears_ when it was last found elsewhere
    std::uint32_t period = 0;  // of its vote; 0: none
    std::uint32_t kept = 0;    // reports of it that are kept back
    std::uint32_t times = 0;   // found elsewhere in a row; of a bee that is named: near in a row
    Place place = Place::kNear;
    Place voted = Place::kNear;  // a bee that is behind may be late, and votes so at the third time
    bool off = false;            // corrected
    bool named = false;          // and not right again
    bool stepped = false;        // its own clock went back when it was first found elsewhere
    bool broken = false;         // what comes next does not go on from what was passed on last
  };

  struct Kept {
    PositionReport report;
    bool ahead;  // when it came; else behind
  };

  Bee& bee_of(AgentId id);
  [[nodiscard]] double reference(double wall_s) const;
  [[nodiscard]] Place place_of(double lead_s) const;
  void vote(Bee& bee, Place place);
  [[nodiscard]] bool most_are(Place place) const;
  [[nodiscard]] double median_lead() const;
  void take_near(const PositionReport& report, Bee& bee, double wall_s, std::vector<Step>& steps);
  void take_elsewhere(const PositionReport& report, Bee& bee, double lasts_s, double wall_s,
                      std::vector<Step>& steps);
  void correct(const PositionReport& report, Bee& bee, double wall_s, std::vector<Step>& steps);
  void name(const PositionReport& report, Bee& bee, std::vector<Step>& steps);
  void pass(const PositionReport& report, Bee& bee, double time_s, std::vector<Step>& steps) const;
  double go_to(double now_s, double wall_s, std::vector<Step>& steps);
  void keep(const PositionReport& report, Bee& bee);
  [[nodiscard]] double first_kept_s(const PositionReport& report) const;
  void drop_kept(AgentId id, Bee& bee);
  void release(double from_s, double wall_s, std::vector<Step>& steps);
  void advance_to(double time_s, double wall_s);

  Limits limits_;
  bool started_ = false;
  double now_s_ = 0.0;
  double now_wall_s_ = 0.0;
  std::vector<Bee> bees_;    // by id
  std::uint64_t nears_ = 0;  // reports that were found near
  // Votes: where each bee was found last, of those heard of in this period or the one before.
  std::uint32_t period_ = 1;
  double period_began_s_ = 0.0;
  std::array<std::uint64_t, 3> votes_ = {};  // by place, in this period
  std::uint64_t votes_before_ = 0;           // of those that have not voted in this one
  std::uint64_t takes_ = 0;
  std::uint64_t next_vote_ = 0;  // takes_ from which on votes may be counted again
  std::deque<Kept> kept_;
  std::uint64_t left_out_ = 0;
  std::uint64_t named_ = 0;
};

}  // namespace beespace::analysis
