// Recordings in whole numbers: when two tracks are in conflict, as connected stretches of time.
//
// Time is cut at every fix of either. Between two cuts both move in straight lines, or one is not
// there, and what is in conflict is convex in time. So two neighbours among cuts and spaces between
// them belong to one stretch if both are in conflict: at it, or somewhere in it.
#pragma once

#include "tests/differential/passage.hpp"

#include <beespace/find_conflicts.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::differential {

// The cuts that enclose a stretch of time.
struct Stretch {
  std::size_t first_cut = 0;
  std::size_t last_cut = 0;
  bool cut_off = false;  // it ends at the last cut because one of the two is not there any longer
};

class PairOracle {
 public:
  // All must outlive it.
  PairOracle(const Track& first, const Track& second, const ConflictOptions& options);

  [[nodiscard]] std::vector<Stretch> stretches() const;

  // The error in a conflict that is reported for this stretch, or nothing. Reported distances are
  // right to within some roundings of coordinates, thresholds and times.
  [[nodiscard]] std::string fault_of(const Conflict& conflict, const Stretch& stretch) const;

  // The same for an instant at which they are reported to be so far apart, and near enough.
  [[nodiscard]] std::string fault_at(double time_s, double distance_m) const;

  [[nodiscard]] double cut_s(std::size_t cut) const { return cuts_[cut]; }

  // How close they ever come, rounded; nothing where they are never there at the same time.
  [[nodiscard]] std::optional<double> closest_m() const;
  // How wrong a reported distance may be.
  [[nodiscard]] double slack_m() const { return slack_m_; }

 private:
  // (at + per_time * t) / scale.
  struct Line {
    Axes at;
    Axes per_time;
    Whole scale = 1;
  };
  // Lengths of the passage are multiplied by the scale.
  struct Window {
    Passage passage;
    Whole scale;
  };

  void choose_units();
  void choose_slack();
  [[nodiscard]] Fraction time_of(double seconds) const;
  [[nodiscard]] Axes place_of(const Track& track, std::size_t fix) const;
  [[nodiscard]] std::optional<Line> line_at(const Track& track, const Fraction& time) const;
  [[nodiscard]] std::optional<Window> window_at(const Fraction& time, double wider_m = 0.0) const;
  [[nodiscard]] std::optional<Window> window_after(std::size_t cut) const;
  [[nodiscard]] bool in_conflict_at(const Fraction& time, double wider_m = 0.0) const;
  [[nodiscard]] double root_of(const Fraction& squared, const Whole& scale) const;
  [[nodiscard]] double distance_at(const Fraction& time) const;

  const Track& first_;
  const Track& second_;
  const ConflictOptions& options_;
  bool apart_;
  int metre_ = 0;     // the exponent of the unit of lengths
  int second_s_ = 0;  // of times
  double slack_m_ = 0.0;
  std::vector<double> cuts_;
};

}  // namespace beespace::differential
