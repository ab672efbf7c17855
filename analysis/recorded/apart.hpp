// How far apart two bees are horizontally and vertically, at one instant.
#pragma once

#include "analysis/geometry/apart.hpp"
#include "analysis/recorded/last_snapshot.hpp"

#include <beespace/conflict.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace beespace::analysis {

// Where a bee is at a time, and its height where heights are apart from positions.
struct Whereabouts {
  Point place;
  std::optional<double> height;
};

// Of a track, between two fixes in the straight line; nothing before the first and after the last.
std::optional<Whereabouts> whereabouts_at(const Track& track, double time_s);

// Of two that both have heights apart from their positions, or neither.
Apart apart(const Whereabouts& a, const Whereabouts& b, double height_unit_m);

// An instant at the end of what is known of both may be rounded to beyond it: the nearest that is
// not. Nothing where they are never known at the same time.
std::optional<double> common_instant(const Track& a, const Track& b, double time_s);

// Of two tracks; nothing where they are never known at the same time. Between two fixes each flies
// straight, whatever gap is between them.
std::optional<Apart> apart_at(const Track& a, const Track& b, double time_s, double height_unit_m);

// How far apart the two of a conflict are when they are closest in it; nothing where that is not
// known.
using ApartOf = std::function<std::optional<Apart>(const Conflict&)>;

// Of tracks, and of bees that fly on as a snapshot has them; times are those of the recording. What
// they are of must outlive them.
ApartOf apart_of(const std::vector<Track>& tracks, double height_unit_m);
ApartOf apart_of(const Snapshot& snapshot, double height_unit_m);

}  // namespace beespace::analysis
