// Where the bees of a recording are above the ground, and how high: what is horizontal between two,
// and what is not.
#pragma once

#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

struct Upright {
  Point ground;  // of geographic positions, at height 0; otherwise with z = 0
  double height_m = 0.0;
};

report::Apart apart(const Upright& one, const Upright& other);

class Uprights {
 public:
  // `in_space` are the tracks of the recording, and outlive this. Errors: those of tracks_of.
  static Result<Uprights> of(const io::Recording& recording, const std::vector<Track>& in_space,
                             double max_gap_s);

  // Absent where the bee is unknown.
  [[nodiscard]] std::optional<Upright> at(PointId bee, double time_s) const;
  // Also in its gaps, on a straight line.
  [[nodiscard]] std::optional<Upright> across_gaps_at(PointId bee, double time_s) const;
  [[nodiscard]] std::optional<Point> in_space_at(PointId bee, double time_s) const;
  [[nodiscard]] const Track& track(PointId bee) const { return (*in_space_)[bee]; }
  [[nodiscard]] bool on_earth() const { return !ground_.empty(); }

 private:
  Uprights(const std::vector<Track>& in_space, double max_gap_s)
      : in_space_(&in_space), max_gap_s_(max_gap_s) {}
  [[nodiscard]] std::optional<Upright> at(PointId bee, double time_s, double max_gap_s) const;

  const std::vector<Track>* in_space_;
  double max_gap_s_;
  std::vector<Track> ground_;   // of geographic positions
  std::vector<Track> heights_;  // theirs, along x
};

}  // namespace beespace::analysis
