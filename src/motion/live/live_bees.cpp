#include "motion/live/live_bees.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace beespace::motion {

namespace {

// Values computed from reports may be smaller or larger than any of them. They are brought back
// into the motion domain, at the cost of less than a millionth of a nanometre, or of being so far
// away that no bee is near.
double in_domain(double value) {
  const double magnitude = std::abs(value);
  if (magnitude < kSmallestInMotion) return 0.0;
  return std::copysign(std::min(magnitude, kLargestInMotion), value);
}

}  // namespace

std::optional<LiveSegment::Now> LiveSegment::at(double now_s) const {
  const Fix& last = fixes.back();
  const bool apart = !heights_m.empty();
  Now now{{last.position, {}}, apart ? heights_m.back() : 0.0, 0.0};
  if (velocity) {
    now.mover.velocity = *velocity;
    now.climb_mps = climb_mps;
  } else if (fixes.size() > 1) {
    const Fix& before = fixes[fixes.size() - 2];
    const double lasts = last.time_s - before.time_s;
    now.mover.velocity = {(last.position.x - before.position.x) / lasts,
                          (last.position.y - before.position.y) / lasts,
                          (last.position.z - before.position.z) / lasts};
    if (apart) now.climb_mps = (heights_m.back() - heights_m[heights_m.size() - 2]) / lasts;
  } else {
    return std::nullopt;
  }
  const double since = now_s - last.time_s;
  Velocity& v = now.mover.velocity;
  v = {in_domain(v.x), in_domain(v.y), in_domain(v.z)};
  now.climb_mps = in_domain(now.climb_mps);
  Point& p = now.mover.position;
  p = {in_domain(p.x + v.x * since), in_domain(p.y + v.y * since), in_domain(p.z + v.z * since)};
  now.height_m = in_domain(now.height_m + now.climb_mps * since);
  return now;
}

void LiveBees::add(LiveSegment& segment, const PositionReport& report) const {
  segment.fixes.push_back({report.time_s, report.position});
  segment.velocity = report.velocity;
  if (!heights_apart_) return;
  segment.heights_m.push_back(report.height_m);
  segment.climb_mps = report.climb_mps;
}

void LiveBees::begin_segment(KnownBee& bee, const PositionReport& report) {
  ++changes_;
  missed_s_ += std::max(0.0, forgotten_until_s_ - report.time_s);
  if (free_.empty()) {
    bee.segment = static_cast<std::uint32_t>(segments_.size());
    segments_.emplace_back();
  } else {
    bee.segment = free_.back();
    free_.pop_back();
  }
  LiveSegment& segment = segments_[bee.segment];
  segment.bee = report.id;
  segment.complete = false;
  add(segment, report);
}

// What becomes of a report that is no later than the last one of its bee. It is compared with the
// last two, which are always known.
std::optional<LiveBees::Taken> LiveBees::before_last(const KnownBee& bee,
                                                     const PositionReport& report) const {
  const Fix fix{report.time_s, report.position};
  const auto compared = [&](const Fix& with, double height_m) {
    const bool same = fix == with && (!heights_apart_ || height_m == report.height_m);
    return same ? Taken::kRepeated : Taken::kContrary;
  };
  if (!bee.has_segment()) {
    if (fix.time_s > bee.last.time_s) return std::nullopt;
    return fix.time_s == bee.last.time_s ? compared(bee.last, bee.height_m) : Taken::kLate;
  }
  const LiveSegment& segment = segments_[bee.segment];
  if (fix.time_s > segment.last_s()) return std::nullopt;
  for (std::size_t back = 1; back <= std::min<std::size_t>(2, segment.fixes.size()); ++back) {
    const std::size_t at = segment.fixes.size() - back;
    if (segment.fixes[at].time_s != fix.time_s) continue;
    return compared(segment.fixes[at], heights_apart_ ? segment.heights_m[at] : 0.0);
  }
  return Taken::kLate;
}

LiveBees::Taken LiveBees::take(const PositionReport& report, double max_age_s,
                               std::size_t max_agents) {
  const auto at = known_.find(report.id);
  if (at == known_.end()) {
    if (known_.size() >= max_agents) return Taken::kFull;
    begin_segment(known_[report.id], report);
    ++once_;
    return Taken::kYes;
  }
  KnownBee& bee = at->second;
  if (!bee.waiting) {
    if (const auto left_out = before_last(bee, report)) return *left_out;
  }
  if (std::exchange(bee.once, false)) --once_;
  if (std::exchange(bee.waiting, false)) {
    --waiting_;
    begin_segment(bee, report);
    return Taken::kYes;
  }
  const bool reported_stale = bee.stale() && !bee.unreported;
  if (bee.has_segment()) {
    LiveSegment& segment = segments_[bee.segment];
    if (report.time_s - segment.last_s() <= max_age_s) {
      add(segment, report);
      return Taken::kYes;
    }
    complete(bee, SegmentEnd::kSilent);
  }
  const double since_s = bee.last.time_s;
  bee.unknown_s += report.time_s - since_s;
  unknown_s_ += report.time_s - since_s;
  returns_.push_back(
      {report.id, since_s, report.time_s, reported_stale, bee.last, bee.height_m, bee.lost});
  bee.lost = bee.unreported = false;
  --stale_;
  begin_segment(bee, report);
  return Taken::kYes;
}

void LiveBees::lose(AgentId bee) {
  const auto known = known_.find(bee);
  if (known == known_.end() || !known->second.has_segment()) return;
  complete(known->second, SegmentEnd::kSilent);
  known->second.lost = known->second.unreported = true;
  lost_.push_back(bee);
}

void LiveBees::remove(AgentId bee) {
  const auto known = known_.find(bee);
  if (known == known_.end()) return;
  if (known->second.has_segment()) complete(known->second, SegmentEnd::kRemoved);
  --(known->second.waiting ? waiting_ : stale_);
  if (known->second.once) --once_;
  ++changes_;
  known_.erase(known);
}

// The bee is stale then, unless it is removed.
void LiveBees::complete(KnownBee& bee, SegmentEnd end) {
  LiveSegment& segment = segments_[bee.segment];
  segment.complete = true;
  segment.end = end;
  bee.last = segment.fixes.back();
  if (heights_apart_) bee.height_m = segment.heights_m.back();
  bee.segment = KnownBee::kStale;
  ++stale_;
  ++changes_;
}

void LiveBees::complete_all(bool anew) {
  for (auto& [id, bee] : known_) {
    if (!bee.has_segment()) continue;
    complete(bee, SegmentEnd::kFinished);
    if (!anew) continue;
    bee.waiting = true;
    --stale_;
    ++waiting_;
  }
}

void LiveBees::begin_anew(double later_s) {
  segments_.clear();
  free_.clear();
  returns_.clear();
  lost_.clear();
  forgotten_until_s_ = LiveSegment::kNever;
  ++changes_;
  for (auto& [id, bee] : known_) {
    bee.last.time_s = in_domain(bee.last.time_s + later_s);
    bee.unreported = false;
  }
}

double LiveBees::known_from_s() const {
  double known_from_s = std::numeric_limits<double>::infinity();
  for (const LiveSegment& segment : segments_) {
    if (!segment.complete) known_from_s = std::min(known_from_s, segment.last_s());
  }
  return known_from_s;
}

void LiveBees::settle(double now_s, double max_age_s) {
  const double from_s = known_from_s();
  for (LiveSegment& segment : segments_) {
    if (!segment.complete || segment.fixes.empty()) continue;
    segment.complete_since_s = std::min(segment.complete_since_s, now_s);
    segment.done = segment.last_s() <= from_s || now_s - segment.complete_since_s > max_age_s;
  }
}

void LiveBees::forget(std::pmr::vector<std::uint32_t>& dropped) {
  const double from_s = known_from_s();
  dropped.assign(segments_.size(), 0);
  for (std::uint32_t place = 0; place < segments_.size(); ++place) {
    LiveSegment& segment = segments_[place];
    if (segment.fixes.empty()) continue;
    forgotten_until_s_ = std::max(forgotten_until_s_, std::min(from_s, segment.last_s()));
    if (segment.done) {
      segment = {};
      free_.push_back(place);
      continue;
    }
    segment.searched_until_s = segment.last_s();
    // The last two are kept, for the velocity.
    while (dropped[place] + 2 < segment.fixes.size() &&
           segment.fixes[dropped[place] + 1].time_s < from_s) {
      ++dropped[place];
    }
    const auto gone = static_cast<std::ptrdiff_t>(dropped[place]);
    segment.fixes.erase(segment.fixes.begin(), segment.fixes.begin() + gone);
    if (heights_apart_) {
      segment.heights_m.erase(segment.heights_m.begin(), segment.heights_m.begin() + gone);
    }
  }
  give_back();
}

// Frees the memory of removed bees, once they are the majority.
void LiveBees::give_back() {
  constexpr std::size_t kFew = 64;
  while (!segments_.empty() && segments_.back().fixes.empty()) segments_.pop_back();
  std::erase_if(free_, [&](std::uint32_t place) { return place >= segments_.size(); });
  if (segments_.capacity() > kFew && segments_.capacity() / 4 > segments_.size()) {
    segments_.shrink_to_fit();
  }
  if (free_.capacity() > kFew && free_.capacity() / 4 > free_.size()) free_.shrink_to_fit();
  if (known_.bucket_count() > kFew && known_.bucket_count() / 8 > known_.size()) known_.rehash(0);
}

}  // namespace beespace::motion
