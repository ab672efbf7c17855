#include "report/fleet_json.hpp"

#include "report/quantised.hpp"
#include "report/swarm_json.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::report {
namespace {

// Ticks as they are told: from the first of all.
class TickCount {
 public:
  TickCount(const FleetFacts& fleet, double begins_s) : period_s_(fleet.period_s) {
    constexpr Tick kNone = std::numeric_limits<Tick>::max();
    first_ = kNone;
    for (const FleetBee& bee : fleet.bees) {
      if (!bee.states.empty()) first_ = std::min(first_, bee.states.front().tick);
      // A branch may be older than what is said first.
      for (const FleetBranch& branch : bee.branches) first_ = std::min(first_, branch.at);
    }
    if (first_ == kNone) first_ = 0;
    meaning_ = {period_s_, static_cast<double>(first_) * period_s_ - begins_s};
  }

  [[nodiscard]] std::uint32_t of(Tick tick) const {
    constexpr Tick kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(tick - first_, kMost));
  }
  [[nodiscard]] const Meaning& meaning() const { return meaning_; }

 private:
  double period_s_;
  Tick first_;
  Meaning meaning_;
};

void write_states(io::JsonWriter& json, const FleetFacts& fleet, const TickCount& count,
                  Columns& columns) {
  std::vector<std::uint32_t> counts;
  std::vector<std::uint32_t> ticks;
  std::vector<std::uint32_t> absent_after;
  std::vector<std::uint32_t> newest;
  std::vector<std::uint32_t> branches;
  std::vector<std::uint8_t> contracts;
  std::vector<std::uint8_t> reasons;
  std::vector<std::uint8_t> certified;
  std::vector<Point> places;
  std::vector<double> tubes_m;
  for (const FleetBee& bee : fleet.bees) {
    counts.push_back(static_cast<std::uint32_t>(bee.states.size()));
    for (std::size_t i = 0; i < bee.states.size(); ++i) {
      const FleetState& state = bee.states[i];
      if (i > 0 && state.tick > bee.states[i - 1].tick + 1) {
        absent_after.push_back(static_cast<std::uint32_t>(ticks.size() - 1));
      }
      ticks.push_back(count.of(state.tick));
      places.push_back(state.nominal);
      tubes_m.push_back(state.tube_m);
      contracts.push_back(static_cast<std::uint8_t>(state.contract));
      reasons.push_back(static_cast<std::uint8_t>(state.reason));
      certified.push_back(state.certified ? 1 : 0);
      branches.push_back(state.branches);
      newest.push_back(state.newest ? *state.newest + 1 : 0);
    }
  }
  json.begin_object("states");
  columns.add(json, "counts", counts);
  columns.add(json, "time_s", ticks, Differences::kSecond, count.meaning());
  write_positions(json, quantised(places, 16), Differences::kSecond, columns);
  columns.add(json, "absent_after", absent_after, Differences::kFirst);
  columns.add(json, "tube_m", tubes_m);
  columns.add(json, "contract", contracts);
  columns.add(json, "reason", reasons);
  columns.add(json, "certified", certified);
  columns.add(json, "branches", branches);
  columns.add(json, "newest", newest, Differences::kFirst);
  json.end();
}

void write_branches(io::JsonWriter& json, const FleetFacts& fleet, const TickCount& count,
                    Columns& columns) {
  std::vector<std::uint32_t> counts;
  std::vector<std::uint32_t> ticks;
  std::vector<std::uint32_t> back;
  std::vector<Point> places;
  std::vector<Point> stops;
  std::vector<double> braking_s;
  for (const FleetBee& bee : fleet.bees) {
    counts.push_back(static_cast<std::uint32_t>(bee.branches.size()));
    for (std::uint32_t i = 0; i < bee.branches.size(); ++i) {
      const FleetBranch& branch = bee.branches[i];
      ticks.push_back(count.of(branch.at));
      places.push_back(branch.place);
      stops.push_back(branch.stop);
      braking_s.push_back(branch.braking_s);
      back.push_back(branch.parent ? i - *branch.parent : 0);
    }
  }
  json.begin_object("branches");
  columns.add(json, "counts", counts);
  columns.add(json, "time_s", ticks, Differences::kSecond, count.meaning());
  write_positions(json, quantised(places, 16), Differences::kSecond, columns);
  json.begin_object("stop");
  write_positions(json, quantised(stops, 16), Differences::kSecond, columns);
  json.end();
  columns.add(json, "braking_s", braking_s);
  columns.add(json, "back", back);
  json.end();
}

}  // namespace

void write_fleet(io::JsonWriter& json, const FleetFacts& fleet, double begins_s, Columns& columns) {
  const TickCount count(fleet, begins_s);
  json.begin_object("fleet").member("title", fleet.title).member("tick_s", fleet.period_s);
  write_states(json, fleet, count, columns);
  write_branches(json, fleet, count, columns);
  json.end();
}

}  // namespace beespace::report
