// The bees of a live swarm: what has been heard of each, as far back as it matters.
#pragma once

#include "motion/runs.hpp"

#include <beespace/swarm.hpp>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace beespace::motion {

// Reports of one bee without a gap. When it comes back after one, another run begins.
struct LiveRun {
  PointId bee = 0;
  bool complete = true;                   // nothing will be added
  std::vector<Fix> fixes = {};            // empty: the place is free
  std::vector<double> heights_m = {};     // empty, or one for each fix
  std::optional<Velocity> velocity = {};  // of the last, where it was given
  double climb_mps = 0.0;
  double searched_until_s = 0.0;  // its last report in the last search; at first its first

  [[nodiscard]] double last_s() const { return fixes.back().time_s; }
  // Now, flying on from the last report; nothing where it was heard of once and without a velocity.
  struct Now {
    Mover mover;
    double height_m;
    double climb_mps;
  };
  [[nodiscard]] std::optional<Now> at(double now_s) const;
};

class LiveBees {
 public:
  explicit LiveBees(bool heights_apart) : heights_apart_(heights_apart) {}

  // Returns what became of the report.
  enum class Taken : std::uint8_t { kYes, kRepeated, kLate };
  Taken take(const Report& report, double max_age_s);

  // A bee that is there no longer; nothing where it is not known.
  void remove(PointId bee);
  // Completes all who were last heard of before `oldest_s`; calls stale(bee, last heard of).
  template <class Stale>
  void complete_stale(double oldest_s, Stale&& stale);

  // Runs by their place, which stays as long as the run does.
  [[nodiscard]] const std::vector<LiveRun>& runs() const { return runs_; }
  [[nodiscard]] std::size_t under_way() const { return under_way_.size(); }
  // Stale, and not heard of since.
  [[nodiscard]] std::size_t stale() const { return stale_.size(); }

  // After a search: forgets complete runs, and fixes before those that the next search needs. Sets
  // dropped[place] to how many fixes of a run are gone. Returns the time from which on all is
  // known.
  double forget(std::vector<std::uint32_t>& dropped);

 private:
  void add(LiveRun& run, const Report& report) const;
  void complete(PointId bee);

  bool heights_apart_;
  std::vector<LiveRun> runs_;
  std::vector<std::uint32_t> free_;                       // places
  std::unordered_map<PointId, std::uint32_t> under_way_;  // bee -> place
  std::unordered_map<PointId, double> stale_;             // bee -> when last heard of
};

template <class Stale>
void LiveBees::complete_stale(double oldest_s, Stale&& stale) {
  for (LiveRun& run : runs_) {
    if (run.fixes.empty() || run.complete || run.last_s() >= oldest_s) continue;
    stale(run.bee, run.last_s());
    run.complete = true;
    under_way_.erase(run.bee);
    stale_[run.bee] = run.last_s();
  }
}

}  // namespace beespace::motion
