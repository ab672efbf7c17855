// What `beespace watch --advise` says: how those should fly on whose way leads too close to others.
//
// Advice has ticks, one a step. The look of a tick is taken when the reports of its own time are
// in, or can no longer be waited for; what it says takes effect at the tick after, and all bees are
// brought forward to that time along what they have been told before. Each would like to fly as it
// did when it last flew otherwise than advised. The contract is in docs/prevention.md.
//
// A bee is certified only while all of this holds, which each look checks:
// - it reports its velocity, and not less often than every second step;
// - two of its reports have been heard at least, and the last one was where advice had led it, to
//   within what is tolerated until the step that is advised ends: by so much the threshold of all
//   pairs is widened;
// - it has its distance from all others, by Adviser::advise; from one that is stale, or was heard
// of
//   once and without a velocity, wherever that may be by its greatest speed;
// - no bee has been heard of whose place is not known at all.
// Otherwise the line says what fails. A bee is never forgotten, until it is removed.
//
// Between positions in degrees the frame is that of the Earth, in which z is not up. The advice
// asks for up only to tell sides apart where there is nothing else to tell them by; any direction
// that all agree on will do.
#pragma once

#include "cli/output/rows.hpp"
#include "cli/watch/advice_line.hpp"
#include "cli/watch/advice_ticks.hpp"
#include "cli/watch/nominal_flight.hpp"
#include "io/recording/recording.hpp"

#include <beespace/advise.hpp>
#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace beespace::cli {

struct LiveAdviceRequest {
  // Its uncertainty is how far from where its advice leads a bee may be and still be certified.
  AdviseOptions options;
  FlightLimits limits;     // who is faster already may stay so
  double max_age_s = 5.0;  // who has not been heard of for longer may be anywhere
};

class LiveAdvice {
 public:
  // What the bees are called; and where the lines of a look go.
  using Name = std::function<const analysis::BeeName&(AgentId id)>;
  using Tell = std::function<void(const std::string& lines)>;
  LiveAdvice(const LiveAdviceRequest& request, io::Frame frame, Name name, Tell tell);

  // Takes a report, in any order, at the time of the swarm, and the looks for which nothing is
  // waited for any more. Errors: as Adviser::advise, of the first look that failed; the next may go
  // well.
  Status take(const PositionReport& report, double now_s);

  // For how long a look that has begun may wait for more, in milliseconds by the clock of the wall;
  // nothing where none has. Then call waited().
  [[nodiscard]] std::optional<int> patience_ms() const;
  Status waited();

  // The clocks of all begin anew, at a time. What was known of places still is, and grows old.
  void start_anew(double time_s);

  // The end of the input: a look that has begun waits no longer.
  Status finish();

  // A bee that is there no longer.
  void remove(AgentId id);

  // Whether a bee has been heard of here; and whether there are others, of which it is not known
  // where they are: then no bee is certified.
  [[nodiscard]] bool knows(AgentId id) const { return bees_.contains(id); }
  void note_unplaced(bool any) { unplaced_ = any; }

  // That the clock of a bee is off, or right again.
  void note_clock(AgentId id, bool off);

  // The lines of bees so far; those of bees that are not certified; looks for which the reports of
  // their time came too late.
  [[nodiscard]] std::uint64_t told() const { return told_; }
  [[nodiscard]] std::uint64_t uncertified() const { return uncertified_; }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  struct Bee {
    NominalFlight flight = {};
    Velocity preferred = {};
    Point last = {};
    double last_s = 0.0;
    double every_s = 0.0;  // between its last two reports; 0 before
    Doubt doubt = Doubt::kHeardOnce;
    bool advised = false;  // once at least
    bool awaited = false;  // by the next look
  };

  void meet(Bee& bee, const PositionReport& report) const;
  void hear(Bee& bee, const PositionReport& report) const;
  [[nodiscard]] bool old(const Bee& bee) const;
  [[nodiscard]] bool unknown(const Bee& bee) const;
  void add(AgentId number, Bee& bee);
  void await(Bee& bee);
  void go_on_to(Tick tick);
  Status take_looks();
  Status look();
  void tell_all();

  LiveAdviceRequest request_;
  AdviceTicks ticks_;
  io::Frame frame_;
  Name name_;
  Tell tell_;
  Adviser adviser_;
  std::map<AgentId, Bee> bees_;
  std::optional<Tick> next_;  // look
  Tick first_ = 0;
  double clock_s_ = 0.0;     // the latest report
  std::size_t awaited_ = 0;  // bees
  std::vector<Mover> movers_;
  std::vector<Velocity> preferred_;
  std::vector<FlightLimits> limits_;
  std::vector<UnknownAgent> unknown_;
  Advised advised_;
  bool unplaced_ = false;
  std::set<AgentId> clocks_off_;
  std::uint64_t told_ = 0;
  std::uint64_t uncertified_ = 0;
  std::uint64_t skipped_ = 0;
};

}  // namespace beespace::cli
