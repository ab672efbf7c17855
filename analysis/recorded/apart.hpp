// How far apart two bees are horizontally and vertically, at one instant.
#pragma once

#include "analysis/geometry/apart.hpp"
#include "analysis/recorded/last_snapshot.hpp"

#include <beespace/conflict.hpp>
#include <beespace/track.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace beespace::analysis {

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
