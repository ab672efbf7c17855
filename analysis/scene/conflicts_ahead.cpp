#include "analysis/scene/conflicts_ahead.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/last_snapshot.hpp"
#include "analysis/recorded/usual_horizon.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "report/earth_frame.hpp"
#include "report/local_axes.hpp"

#include <beespace/predict_conflicts.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr std::size_t kMostTold = 20;

// Where each of them is after a time, to look at.
class PlacesAhead {
 public:
  PlacesAhead(const Snapshot& in_space, const std::vector<std::uint32_t>& bees,
              const report::SnapshotFacts& facts)
      : in_space_(in_space), bees_(bees) {
    if (facts.swarm.origin) frame_.emplace(*facts.swarm.origin);
  }

  // Its number among the positions of the facts.
  [[nodiscard]] PointId shown(std::uint32_t bee) const {
    return static_cast<PointId>(std::find(bees_.begin(), bees_.end(), bee) - bees_.begin());
  }

  [[nodiscard]] Point after(std::uint32_t bee, double seconds) const {
    const auto at = std::lower_bound(in_space_.bees.begin(), in_space_.bees.end(), bee);
    const Mover& mover = in_space_.movers[static_cast<std::size_t>(at - in_space_.bees.begin())];
    const Point& p = mover.position;
    const Velocity& v = mover.velocity;
    const Point there{p.x + v.x * seconds, p.y + v.y * seconds, p.z + v.z * seconds};
    if (!frame_) return there;
    // A straight line in space rises above the ground: heights are those that it climbs to.
    Point place = frame_->place_of(there);
    place.z = frame_->place_of(p).z + report::to_local_velocity(p, v).up_mps * seconds;
    return place;
  }

 private:
  const Snapshot& in_space_;
  const std::vector<std::uint32_t>& bees_;
  std::optional<report::EarthFrame> frame_;
};

// Those that begin after the moment itself, by the numbers and times of the recording, the worst
// first, and of those that are as bad the soonest.
std::vector<Conflict> later_ones(std::vector<Conflict> conflicts, const Snapshot& snapshot,
                                 const WorstOf& worst) {
  std::erase_if(conflicts, [](const Conflict& each) { return !(each.begins_s > 0.0); });
  for (Conflict& each : conflicts) {
    each.first = snapshot.bees[each.first];
    each.second = snapshot.bees[each.second];
    each.begins_s += snapshot.time_s;
    each.closest_s += snapshot.time_s;
    each.ends_s += snapshot.time_s;
  }
  std::stable_sort(conflicts.begin(), conflicts.end(),
                   [](const Conflict& a, const Conflict& b) { return a.begins_s < b.begins_s; });
  sort_worst_first(worst, conflicts);
  return conflicts;
}

}  // namespace

Status look_ahead(const io::Recording& recording, const std::vector<std::uint32_t>& bees,
                  const SceneRequest& request, report::SnapshotFacts& facts) {
  const Geometry geometry = geometry_for(recording, request.vertical);
  const auto snapshot = snapshot_of(recording, geometry, kMaxAgeShown_s, Wanted::kMotionOrNow);
  const auto in_space =
      snapshot_of(recording, Geometry::kSpace, kMaxAgeShown_s, Wanted::kMotionOrNow);
  for (const auto* of : {&snapshot, &in_space}) {
    if (!*of && of->error().code == ErrorCode::kMissingColumn) return std::monostate{};
    if (!*of) return of->error();
  }
  if (snapshot->movers.empty()) return std::monostate{};
  report::Ahead ahead;
  ahead.horizon_s = request.horizon_s.value_or(usual_horizon_s(recording));
  ahead.complete = snapshot->stale == 0 && snapshot->unmoving.empty() && recording.missing.none();
  const double unit_m = height_unit_m(geometry, recording.height_unit);
  auto conflicts = predict_conflicts(
      snapshot->view(),
      {.threshold_m = facts.swarm.threshold_m,
       .vertical_m = vertical_in(geometry, request.vertical, recording.height_unit),
       .horizon_s = ahead.horizon_s,
       .inclusive = request.inclusive,
       .threads = request.threads,
       .height_unit_m = unit_m});
  if (!conflicts && conflicts.error().code == ErrorCode::kTooManyResults) return std::monostate{};
  if (!conflicts) return std::move(conflicts).error();
  WorstOf worst;
  if (facts.swarm.vertical_m) {
    worst = worst_of(*snapshot, unit_m, {facts.swarm.threshold_m, *facts.swarm.vertical_m});
  }
  std::vector<Conflict> later = later_ones(*std::move(conflicts), *snapshot, worst);
  ahead.count = later.size();
  const PlacesAhead places(*in_space, bees, facts);
  later.resize(std::min(kMostTold, later.size()));
  ahead.conflicts.reserve(later.size());
  for (const Conflict& told : later) {
    const auto moment = worst ? worst(told) : std::nullopt;
    const double closest_s = (moment ? moment->time_s : told.closest_s) - snapshot->time_s;
    report::ConflictAhead each{places.shown(told.first), places.shown(told.second),
                               told.begins_s - snapshot->time_s, closest_s, told.closest_m};
    if (moment) each.apart = report::Apart{moment->apart.horizontal_m, moment->apart.vertical_m};
    each.first_there = places.after(told.first, closest_s);
    each.second_there = places.after(told.second, closest_s);
    ahead.conflicts.push_back(each);
  }
  facts.ahead = std::move(ahead);
  return std::monostate{};
}

}  // namespace beespace::analysis
