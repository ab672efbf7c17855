#include "io/recording/track_gathering.hpp"

#include "io/frames/track_domain.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/recording/jumped_stretches.hpp"
#include "io/recording/overlapping_files.hpp"
#include "io/recording/restarted_clock.hpp"
#include "io/recording/shared_id.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace beespace::io {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool strictly_ascending(const std::vector<Fix>& fixes) {
  return std::adjacent_find(fixes.begin(), fixes.end(), [](const Fix& a, const Fix& b) {
           return !(a.time_s < b.time_s);
         }) == fixes.end();
}

// A drone of a show: a bee of its own, whatever its id.
bool is_of_show(const RecordedBee& bee) {
  return bee.path || bee.stands;
}

// Whether the later fix is the earlier one, said twice. With rounded times the height may have
// been heard of anew in between: it comes by other messages than the position.
bool is_heard_again(const Fix& earlier, const Fix& later, std::optional<double> repeat_s) {
  if (!repeat_s) return earlier == later;
  return later.time_s - earlier.time_s <= *repeat_s && earlier.position.x == later.position.x &&
         earlier.position.y == later.position.y;
}

// How fast it says that it flies; or else faster than any airliner.
double speed_or_fastest(const std::vector<Velocity>& velocities, std::size_t fix) {
  constexpr double kFastest_mps = 350.0;
  if (velocities.empty()) return kFastest_mps;
  const double speed_mps = std::hypot(velocities[fix].x, velocities[fix].y);
  return std::isfinite(speed_mps) ? speed_mps : kFastest_mps;
}

// Of one moment, as times are written: whether it does not get from one place to the other
// meanwhile.
bool is_far(const Fix& earlier, const Fix& later, double speed_mps, double repeat_s, Frame frame) {
  constexpr double kSecond = 1.0;        // times are rounded to seconds often
  constexpr double kSolutions_m = 30.0;  // so far apart are two solutions of one receiver
  return flat_distance_m(earlier.position, later.position, frame) >
         speed_mps * std::max(kSecond, repeat_s) + kSolutions_m;
}

}  // namespace

TrackGathering::Bee& TrackGathering::bee_of(std::string_view id) {
  if (last_ < bees_.size() && bees_[last_].recorded.id == id && !bees_[last_].recorded.path) {
    return bees_[last_];
  }
  const auto found = index_.find(id);
  if (found != index_.end()) {
    last_ = found->second;
    return bees_[last_];
  }
  last_ = bees_.size();
  index_.emplace(std::string(id), last_);
  bees_.emplace_back().recorded.id = std::string(id);
  return bees_.back();
}

void TrackGathering::add(std::string_view id, const Fix& fix, const Velocity* velocity,
                         Origin origin, std::optional<double> stated_height) {
  Bee& bee = bee_of(id);
  auto& fixes = bee.recorded.fixes;
  auto& velocities = bee.recorded.velocities;
  if (!fixes.empty()) {
    const bool same_source = bee.origins.back().source == origin.source;
    if (same_source && fix.time_s < fixes.back().time_s) ++out_of_order_;
    if (!same_source && !bee.several_sources) {
      bee.several_sources = true;
      ++in_several_sources_;
    }
  }
  if (velocity != nullptr) {
    any_velocity_ = any_velocity_ || std::isfinite(velocity->x + velocity->y + velocity->z);
    velocities.resize(fixes.size(), {kUnknown, kUnknown, kUnknown});
    velocities.push_back(*velocity);
  } else if (!velocities.empty()) {
    velocities.push_back({kUnknown, kUnknown, kUnknown});
  }
  auto& heights = bee.recorded.stated_heights;
  if (stated_height || !heights.empty()) {
    heights.resize(fixes.size(), kUnknown);
    heights.push_back(stated_height.value_or(kUnknown));
  }
  // Degrees and heights that were computed may be dust, whatever the input is written in.
  fixes.push_back({without_dust(fix.time_s), without_dust(fix.position)});
  bee.origins.push_back(origin);
  const double time_s = fixes.back().time_s;
  if (origin.source >= spans_.size()) spans_.resize(origin.source + std::size_t{1});
  auto& span = spans_[origin.source];
  if (!span) span = TimeSpan{time_s, time_s};
  span->begins_s = std::min(span->begins_s, time_s);
  span->ends_s = std::max(span->ends_s, time_s);
  if (bee.waits) return;
  bee.waits = true;
  waiting_.push_back(last_);
}

void TrackGathering::drain(const Take& take) {
  struct Place {
    std::size_t bee;
    std::size_t fix;
    Origin origin;
  };
  std::vector<Place> places;
  for (const std::size_t number : waiting_) {
    const Bee& bee = bees_[number];
    for (std::size_t at = bee.taken; at < bee.recorded.fixes.size(); ++at) {
      places.push_back({number, at, bee.origins[at]});
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    if (a.origin.source != b.origin.source) return a.origin.source < b.origin.source;
    return a.origin.line < b.origin.line;
  });
  for (const auto& [number, at, origin] : places) {
    const RecordedBee& bee = bees_[number].recorded;
    take({number, bee.fixes[at], bee.velocities.empty() ? nullptr : &bee.velocities[at],
          bee.stated_heights.empty() ? std::nullopt : std::optional(bee.stated_heights[at]),
          origin});
  }
  // The last one stays, which the next one is compared with.
  for (const std::size_t number : waiting_) {
    Bee& bee = bees_[number];
    bee.waits = false;
    bee.taken = 1;
    bee.recorded.fixes = std::vector<Fix>{bee.recorded.fixes.back()};
    bee.origins = std::vector<Origin>{bee.origins.back()};
    std::vector<Velocity>().swap(bee.recorded.velocities);
    std::vector<double>().swap(bee.recorded.stated_heights);
  }
  waiting_.clear();
}

void TrackGathering::label(std::string_view id, std::string_view text, double time_s) {
  auto& called = bee_of(id).recorded.called;
  if (called.empty() || called.back().label != text) called.push_back({time_s, std::string(text)});
}

void TrackGathering::add_path(std::string id, BezierPath path) {
  Bee& bee = bees_.emplace_back();
  bee.recorded.id = std::move(id);
  bee.recorded.path = std::move(path);
}

void TrackGathering::add_standing(std::string id, const Point& at) {
  Bee& bee = bees_.emplace_back();
  bee.recorded.id = std::move(id);
  bee.recorded.stands = at;
}

std::optional<TimeSpan> TrackGathering::span_of(std::uint32_t source) const {
  return source < spans_.size() ? spans_[source] : std::nullopt;
}

Origin TrackGathering::origin(std::size_t index) const {
  for (const Bee& bee : bees_) {
    if (index < bee.origins.size()) return bee.origins[index];
    index -= bee.origins.size();
  }
  return {};
}

std::vector<Point> TrackGathering::positions() const {
  std::size_t count = 0;
  for (const Bee& bee : bees_) count += bee.recorded.fixes.size();
  std::vector<Point> points;
  points.reserve(count);
  for (const Bee& bee : bees_) {
    for (const Fix& fix : bee.recorded.fixes) points.push_back(fix.position);
  }
  return points;
}

double TrackGathering::highest_m() const {
  double highest_m = 0.0;
  for (const Bee& bee : bees_) {
    for (const Fix& fix : bee.recorded.fixes) highest_m = std::max(highest_m, fix.position.z);
  }
  return highest_m;
}

void TrackGathering::settle(Frame frame, const TakeConflict& conflict, const TakeConflict& far) {
  for (Bee& bee : bees_) {
    if (repeat_s_ || !strictly_ascending(bee.recorded.fixes)) settle(bee, frame, conflict, far);
  }
}

void TrackGathering::settle(Bee& bee, Frame frame, const TakeConflict& conflict,
                            const TakeConflict& far) {
  const auto& fixes = bee.recorded.fixes;
  const auto& velocities = bee.recorded.velocities;
  const auto& heights = bee.recorded.stated_heights;
  std::vector<std::size_t> order(fixes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&fixes](std::size_t a, std::size_t b) {
    return fixes[a].time_s < fixes[b].time_s;
  });
  Bee settled;
  for (const std::size_t i : order) {
    if (!settled.recorded.fixes.empty()) {
      const Fix& last = settled.recorded.fixes.back();
      if (is_heard_again(last, fixes[i], repeat_s_)) {
        ++repeated_;
        ++settled.recorded.repeats;
        ++settled.recorded.repeats_of_last;
        continue;
      }
      if (last.time_s == fixes[i].time_s) {
        const TimeConflict both{bee.recorded.id, fixes[i].time_s, settled.origins.back(),
                                bee.origins[i]};
        if (repeat_s_) {
          if (bee.clashes++ == 0) {
            bee.clashed = SharedTrack{bee.recorded.id, fixes[i].time_s, bee.origins[i]};
          }
          if (is_far(last, fixes[i], speed_or_fastest(velocities, i), *repeat_s_, frame)) {
            far(both);
          } else {
            ++clashing_;
          }
        } else {
          conflict(both);
        }
        continue;
      }
    }
    settled.recorded.fixes.push_back(fixes[i]);
    settled.recorded.repeats_of_last = 0;
    if (!velocities.empty()) settled.recorded.velocities.push_back(velocities[i]);
    if (!heights.empty()) settled.recorded.stated_heights.push_back(heights[i]);
    settled.origins.push_back(bee.origins[i]);
  }
  bee.recorded.fixes = std::move(settled.recorded.fixes);
  bee.recorded.repeats = settled.recorded.repeats;
  bee.recorded.repeats_of_last = settled.recorded.repeats_of_last;
  bee.recorded.velocities = std::move(settled.recorded.velocities);
  bee.recorded.stated_heights = std::move(settled.recorded.stated_heights);
  bee.origins = std::move(settled.origins);
}

std::vector<SharedTrack> TrackGathering::shared(Frame frame) const {
  constexpr std::uint64_t kMany = 16;  // as many as take it to be sure of jumps
  std::vector<SharedTrack> shared;
  for (const Bee& bee : bees_) {
    const auto& fixes = bee.recorded.fixes;
    // One place a moment: two that come together time after time are two bees.
    if (repeat_s_ == 0.0 && bee.clashes >= kMany && 4 * bee.clashes >= fixes.size()) {
      shared.push_back(*bee.clashed);
      continue;
    }
    SharedId id;
    for (const Fix& fix : fixes) id.take(fix, frame);
    if (const auto at = id.found()) {
      shared.push_back({bee.recorded.id, fixes[*at].time_s, bee.origins[*at]});
    }
  }
  return shared;
}

std::vector<TimeConflict> TrackGathering::contradicting(Frame frame) const {
  std::vector<TimeConflict> found;
  for (const Bee& bee : bees_) {
    if (!bee.several_sources) continue;
    const auto source_of = [&bee](std::size_t fix) {
      return static_cast<std::uint32_t>(bee.origins[fix].source);
    };
    const auto at = find_contradiction(bee.recorded.fixes, source_of, frame);
    if (!at) continue;
    found.push_back({bee.recorded.id, bee.recorded.fixes[at->fix].time_s, bee.origins[at->before],
                     bee.origins[at->fix]});
  }
  return found;
}

std::optional<RestartedClock> TrackGathering::restarted(Frame frame) const {
  std::vector<BeeClock> bees;
  bees.reserve(bees_.size());
  for (const Bee& bee : bees_) {
    const auto& fixes = bee.recorded.fixes;
    bees.push_back(fixes.empty() ? BeeClock{} : clock_of(fixes, bee.origins, frame));
  }
  return restarted_clock(bees);
}

std::vector<SharedTrack> TrackGathering::jumping(const JumpsOf& of) const {
  std::vector<SharedTrack> jumping;
  for (const Bee& bee : bees_) {
    const auto at = first_jump(bee.recorded, of);
    if (!at) continue;
    jumping.push_back({bee.recorded.id, bee.recorded.fixes[*at].time_s, bee.origins[*at]});
  }
  return jumping;
}

void TrackGathering::leave_out(const Which& which, const Told& told) {
  const auto empties = [&](Bee& bee) {
    RecordedBee& recorded = bee.recorded;
    const std::vector<bool> none = which(recorded);
    if (none.empty()) return false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < recorded.fixes.size(); ++i) {
      if (none[i]) {
        told(recorded.id, recorded.fixes[i]);
        continue;
      }
      recorded.fixes[kept] = recorded.fixes[i];
      bee.origins[kept] = bee.origins[i];
      if (!recorded.velocities.empty()) recorded.velocities[kept] = recorded.velocities[i];
      if (!recorded.stated_heights.empty()) {
        recorded.stated_heights[kept] = recorded.stated_heights[i];
      }
      ++kept;
    }
    recorded.fixes.resize(kept);
    bee.origins.resize(kept);
    if (!recorded.velocities.empty()) recorded.velocities.resize(kept);
    if (!recorded.stated_heights.empty()) recorded.stated_heights.resize(kept);
    return kept == 0;
  };
  if (std::erase_if(bees_, empties) == 0) return;
  index_.clear();
  for (std::size_t i = 0; i < bees_.size(); ++i) {
    if (!is_of_show(bees_[i].recorded)) index_.emplace(bees_[i].recorded.id, i);
  }
  last_ = 0;
}

std::vector<RecordedBee> TrackGathering::release() {
  std::vector<RecordedBee> released;
  released.reserve(bees_.size());
  std::unordered_set<std::string> ids;
  for (const Bee& bee : bees_) {
    if (!is_of_show(bee.recorded)) ids.insert(bee.recorded.id);
  }
  std::unordered_map<std::string, std::size_t> next;
  for (Bee& bee : bees_) {
    std::string& id = bee.recorded.id;
    if (is_of_show(bee.recorded) && !ids.insert(id).second) {
      std::size_t& number = next.try_emplace(id, 2).first->second;
      std::string other;
      do {
        other = id + "#" + std::to_string(number++);
      } while (!ids.insert(other).second);
      id = std::move(other);
      ++renamed_;
    }
    released.push_back(std::move(bee.recorded));
  }
  bees_.clear();
  index_.clear();
  return released;
}

}  // namespace beespace::io
