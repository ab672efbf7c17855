// Copies of movers and tracks in which values too small for exact comparison are flushed to zero
// (see flush.hpp). Only inputs with such values need a copy.
#pragma once

#include "motion/flush.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace beespace::motion {

class FlushedMovers {
 public:
  explicit FlushedMovers(const MoversView& movers) {
    movers_.reserve(movers.size());
    for (std::size_t i = 0; i < movers.size(); ++i) movers_.push_back(flushed(movers[i]));
    for (const double height : movers.heights_m()) heights_m_.push_back(flushed(height));
    for (const double climb : movers.climbs_mps()) climbs_mps_.push_back(flushed(climb));
  }

  [[nodiscard]] MoversView view() const {
    const MoversView straight(movers_);
    return {straight.positions(), straight.velocities(), heights_m_, climbs_mps_};
  }

 private:
  std::vector<Mover> movers_;
  std::vector<double> heights_m_;
  std::vector<double> climbs_mps_;
};

inline std::vector<Track> flushed(std::span<const Track> tracks) {
  std::vector<Track> copies(tracks.begin(), tracks.end());
  for (Track& track : copies) {
    for (Fix& fix : track.fixes) fix = flushed(fix);
    for (double& height : track.heights_m) height = flushed(height);
  }
  return copies;
}

// Runs the query, and where a value lies outside the motion domain, runs it again on a flushed
// copy: the value may only have been too small. Values that are too large are refused then.
template <class Ask>
auto with_small_values_flushed(const MoversView& movers, Ask&& ask) {
  auto answer = ask(movers);
  if (answer || answer.error().code != ErrorCode::kOutsideDomain) return answer;
  const FlushedMovers copy(movers);
  return ask(copy.view());
}
template <class Ask>
auto with_small_values_flushed(std::span<const Track> tracks, Ask&& ask) {
  auto answer = ask(tracks);
  if (answer || answer.error().code != ErrorCode::kOutsideDomain) return answer;
  const std::vector<Track> copies = flushed(tracks);
  return ask(std::span<const Track>(copies));
}

}  // namespace beespace::motion
