#include "analysis/scene/uprights.hpp"

#include "analysis/recorded/tracks.hpp"

#include <beespace/nearest.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace beespace::analysis {
namespace {

// Geographic input has fixes, not curves.
constexpr double kNoTolerance_m = 0.001;

}  // namespace

report::Apart apart(const Upright& one, const Upright& other) {
  return {distance(one.ground, other.ground), std::abs(one.height_m - other.height_m)};
}

Result<Uprights> Uprights::of(const io::Recording& recording, const std::vector<Track>& in_space,
                              double max_gap_s) {
  Uprights uprights(in_space, max_gap_s);
  if (recording.frame != io::Frame::kWgs84) return uprights;
  auto ground = tracks_of(recording, Geometry::kGroundAndHeight, kNoTolerance_m);
  if (!ground) return std::move(ground).error();
  uprights.ground_ = *std::move(ground);
  for (const Track& track : uprights.ground_) {
    Track& heights = uprights.heights_.emplace_back();
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      heights.fixes.push_back({track.fixes[i].time_s, {track.heights_m[i], 0.0, 0.0}});
    }
  }
  return uprights;
}

std::optional<Upright> Uprights::at(PointId bee, double time_s) const {
  return at(bee, time_s, max_gap_s_);
}

std::optional<Upright> Uprights::across_gaps_at(PointId bee, double time_s) const {
  return at(bee, time_s, std::numeric_limits<double>::infinity());
}

std::optional<Upright> Uprights::at(PointId bee, double time_s, double max_gap_s) const {
  if (!on_earth()) {
    const auto place = position_at((*in_space_)[bee], time_s, max_gap_s);
    if (!place) return std::nullopt;
    return Upright{{place->x, place->y, 0.0}, place->z};
  }
  const auto ground = position_at(ground_[bee], time_s, max_gap_s);
  const auto height = position_at(heights_[bee], time_s, max_gap_s);
  if (!ground || !height) return std::nullopt;
  return Upright{*ground, height->x};
}

std::optional<Point> Uprights::in_space_at(PointId bee, double time_s) const {
  return position_at((*in_space_)[bee], time_s, max_gap_s_);
}

}  // namespace beespace::analysis
