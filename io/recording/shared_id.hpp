// Whether two bees report under one id: a bee that seems to jump to and fro at each report.
//
// A report "jumps" where the ones before and after it are at least four times as far from it as
// from each other, and the turn there would take more than kImpossible_mps2. A wild fix does so
// once; a place that is rounded, or two solutions of a receiver, toss a coin at most. What is
// weighed is how much better than by a coin the last reports are explained by two bees that report
// in turn (a sum of logarithms that begins anew where it falls below zero); by a coin one bee in a
// thousand would be taken for two, however long it is looked at. It takes some twenty reports. More
// than two, and two at different rates, are found as a mixture of tracks (track_mixture.hpp).
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/track_mixture.hpp"

#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <optional>

namespace beespace::io {

class SharedId {
 public:
  // Reports in the order of time; what goes back in it is left out of account. Positions are metres
  // or, of kWgs84, degrees and metres.
  void take(const Fix& fix, Frame frame = Frame::kMetres);

  // Which report, counted from 0 in the order in which they were taken, was the first to jump of
  // those that have shown it; nothing as long as there is one bee.
  [[nodiscard]] std::optional<std::uint64_t> found() const { return found_; }

  // About 5 g, at each report, over and over: what waggles or trembles takes less.
  static constexpr double kImpossible_mps2 = 50.0;

 private:
  void weigh(bool jumps);

  Fix before_ = {};
  Fix last_ = {};
  std::uint64_t taken_ = 0;
  std::uint64_t kept_ = 0;  // of these: how many did not go back in time
  std::uint64_t began_ = 0;
  double weight_ = 0.0;
  TrackMixture mixture_ = TrackMixture(kImpossible_mps2);
  std::optional<std::uint64_t> found_;
};

}  // namespace beespace::io
