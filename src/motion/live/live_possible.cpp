#include "motion/live/live_possible.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace beespace::motion {

namespace {

// An upper limit of the rounding errors here.
constexpr double kUpward = 1.0 + 0x1p-40;

double age_s(const Fix& last, double now_s) {
  return std::abs(now_s - last.time_s);
}

// The distance that both balls must bridge before the two are in conflict, in one direction; and
// whether they do.
struct Bridge {
  double distance;
  double threshold;
  double largest;  // magnitude of the terms

  [[nodiscard]] double gap() const { return distance - threshold; }
  [[nodiscard]] bool closed(double grown) const {
    return distance < (threshold + grown) * kUpward + 0x1p-44 * largest;
  }
};

double largest_of(const Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace

// For each known bee: its position at the last call, and later ones.
void LivePossible::note_places(const LiveBees& bees, const std::vector<Return>& returns) {
  places_.clear();
  heard_.clear();
  for (const LiveSegment& segment : bees.segments()) {
    if (segment.fixes.empty() || (segment.complete && segment.end == SegmentEnd::kRemoved))
      continue;
    std::size_t first = segment.fixes.size() - 1;
    while (first > 0 && segment.fixes[first].time_s > reported_until_s_) --first;
    for (std::size_t i = first; i < segment.fixes.size(); ++i) {
      const double height_m = segment.heights_m.empty() ? 0.0 : segment.heights_m[i];
      places_.push_back({segment.bee, segment.fixes[i], height_m, max_age_s_});
    }
  }
  for (const auto& [id, bee] : bees.known()) {
    if (bee.has_segment()) continue;
    places_.push_back({id, bee.last, bee.height_m, bee.lost ? 0.0 : max_age_s_});
  }
  for (const Return& back : returns) {
    if (!bees.known().contains(back.bee)) continue;
    places_.push_back({back.bee, back.last, back.height_m, back.lost ? 0.0 : max_age_s_});
  }
  // If a place is known twice, the one that is known to be lost is the better one.
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::tie(a.bee, a.at.time_s, a.silent_after_s) <
           std::tie(b.bee, b.at.time_s, b.silent_after_s);
  });
  const auto same = [](const Place& a, const Place& b) {
    return a.bee == b.bee && a.at.time_s == b.at.time_s;
  };
  places_.erase(std::unique(places_.begin(), places_.end(), same), places_.end());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (heard_.empty() || heard_.back().bee != places_[i].bee)
      heard_.push_back({places_[i].bee, i, i});
    heard_.back().end = i + 1;
  }
}

// Begins new silences, and ends others with what is known last; nothing is known of removed bees.
void LivePossible::follow(const LiveBees& bees, const std::vector<Return>& returns) {
  auto before = std::exchange(silent_, {});
  for (const Return& back : returns) {
    if (!bees.known().contains(back.bee)) continue;
    silent_.push_back(
        {{back.bee, back.last, back.height_m, back.lost ? 0.0 : max_age_s_}, back.heard_s});
  }
  for (const auto& [id, bee] : bees.known()) {
    if (!bee.stale()) continue;
    silent_.push_back({{id, bee.last, bee.height_m, bee.lost ? 0.0 : max_age_s_}});
  }
  const auto key = [](const Silent& silent) {
    return std::tie(silent.last.bee, silent.last.at.time_s);
  };
  std::sort(silent_.begin(), silent_.end(),
            [&](const Silent& a, const Silent& b) { return key(a) < key(b); });
  auto known = before.begin();
  for (Silent& silent : silent_) {
    while (known != before.end() && key(*known) < key(silent)) ++known;
    if (known == before.end() || key(*known) != key(silent)) continue;
    silent.reported = std::move(known->reported);
    silent.all_reported_at = known->all_reported_at;
  }
}

// Whether a conflict is possible then, by the last reports of both.
std::optional<SwarmEvent> LivePossible::possible(const Place& silent, const Place& other,
                                                 double at_s) const {
  const Point& p = silent.at.position;
  const Point& q = other.at.position;
  const double grown_m = max_speed_mps_ * (age_s(silent.at, at_s) + age_s(other.at, at_s));
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  const double z = q.z - p.z;
  const double largest = std::max(largest_of(p), largest_of(q));
  const bool level = enter_.vertical_m && !enter_.heights_apart;
  const Bridge across{std::sqrt(x * x + y * y + (level ? 0.0 : z * z)), enter_.threshold_m,
                      largest};
  if (!across.closed(grown_m)) return std::nullopt;
  double gap_m = across.gap();
  double rise_m = level ? z : 0.0;
  if (enter_.vertical_m) {
    const double unit_m = enter_.heights_apart ? enter_.height_unit_m : 1.0;
    const double rise = enter_.heights_apart ? other.height_m - silent.height_m : z;
    const Bridge up{std::abs(rise), *enter_.vertical_m,
                    std::max({largest, std::abs(other.height_m), std::abs(silent.height_m)})};
    if (!up.closed(grown_m / unit_m)) return std::nullopt;
    gap_m = std::max(gap_m, up.gap() * unit_m);
    rise_m = rise * unit_m;
  }
  const double latest_s = std::max(silent.at.time_s, other.at.time_s);
  double since_s = latest_s;
  if (gap_m > 0.0 && max_speed_mps_ > 0.0) {
    const double middle_s = 0.5 * (silent.at.time_s + other.at.time_s);
    since_s =
        std::clamp(middle_s + 0.5 * gap_m / max_speed_mps_, latest_s, std::max(latest_s, at_s));
  }
  const bool both = at_s - other.at.time_s > other.silent_after_s;
  const double silent_since_s =
      both ? std::min(silent.at.time_s, other.at.time_s) : silent.at.time_s;
  return SwarmEvent{EventKind::kPossible,
                    since_s,
                    std::min(silent.bee, other.bee),
                    std::max(silent.bee, other.bee),
                    std::hypot(across.distance, rise_m),
                    since_s,
                    silent_since_s};
}

// Whether a conflict has been reported as possible for the two, and still is. If two are silent,
// the lower one reports at each time.
bool LivePossible::judge(std::size_t index, const Heard& other, bool reported, double now_s,
                         std::vector<Found>& found) const {
  const Silent& silent = silent_[index];
  const bool reported_before = reported;
  bool again = false;
  for (std::size_t i = other.begin; i < other.end; ++i) {
    const Place& at = places_[i];
    if (i > other.begin &&
        at.at.time_s - places_[i - 1].at.time_s > places_[i - 1].silent_after_s) {
      // It has been heard again: what was reported of it is over.
      again = true;
      reported = false;
      if (!found.empty() && found.back().silent == index && found.back().other == other.bee) {
        found.back().goes_on = false;
      }
    }
    if (reported) continue;
    double until_s = i + 1 < other.end ? places_[i + 1].at.time_s : now_s;
    until_s = std::min({until_s, silent.ends_s, now_s});
    if (other.bee < silent.last.bee && until_s - at.at.time_s > at.silent_after_s) {
      until_s = at.at.time_s + at.silent_after_s;
    }
    if (until_s <= reported_until_s_ || until_s < at.at.time_s) continue;
    if (!(until_s - silent.last.at.time_s > silent.last.silent_after_s)) continue;
    const auto event = possible(silent.last, at, until_s);
    if (!event) continue;
    found.push_back({*event, index, other.bee, silent.goes_on()});
    reported = true;
  }
  return reported_before && !again;
}

void LivePossible::look_around(std::size_t index, double now_s, std::vector<Found>& found) {
  Silent& silent = silent_[index];
  silent.unreported = 0;
  std::vector<AgentId> still;
  still.reserve(silent.reported.size());
  auto reported = silent.reported.begin();
  for (const Heard& other : heard_) {
    while (reported != silent.reported.end() && *reported < other.bee) ++reported;
    if (other.bee == silent.last.bee) continue;
    const bool was_reported = reported != silent.reported.end() && *reported == other.bee;
    if (judge(index, other, was_reported, now_s, found)) {
      still.push_back(other.bee);
      continue;
    }
    const Place& last = places_[other.end - 1];
    const bool it_reports =
        other.bee < silent.last.bee && now_s - last.at.time_s > last.silent_after_s;
    if (!it_reports) ++silent.unreported;
  }
  silent.reported = std::move(still);
}

LeftOut LivePossible::search(const LiveBees& bees, const std::vector<Return>& returns, double now_s,
                             const core::Resources& with, std::vector<SwarmEvent>& events) {
  LeftOut left_out;
  if (bees.stale() == 0 && returns.empty()) {
    silent_.clear();
    reported_until_s_ = now_s;
    return left_out;
  }
  note_places(bees, returns);
  follow(bees, returns);
  const auto closer = [](const Found& a, const Found& b) {
    return std::tie(a.event.distance_m, a.event.first, a.event.second, a.event.time_s) <
           std::tie(b.event.distance_m, b.event.first, b.event.second, b.event.time_s);
  };
  // No more than the closest for which there is room, and as many again.
  const auto cut = [&](std::vector<Found>& found, std::size_t most, LeftOut& left) {
    if (found.size() <= most) return;
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(found.begin(), end, found.end(), closer);
    left.add(found.size() - most, end->event.distance_m);
    found.resize(most);
  };
  const std::size_t workers = with.crew.size();
  std::vector<std::vector<Found>> found(workers);
  std::vector<LeftOut> left(workers);
  with.crew.split(silent_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      Silent& silent = silent_[i];
      if (silent.all_reported_at == bees.changes()) continue;
      look_around(i, now_s, found[worker]);
      silent.all_reported_at = silent.unreported == 0 ? bees.changes() : 0;
      if (found[worker].size() > 2 * max_pairs_) cut(found[worker], max_pairs_, left[worker]);
    }
  });
  reported_until_s_ = now_s;
  std::size_t reported = 0;
  for (const Silent& silent : silent_) reported += silent.reported.size();
  std::vector<Found> all;
  for (std::size_t worker = 0; worker < workers; ++worker) {
    all.insert(all.end(), found[worker].begin(), found[worker].end());
    if (left[worker].any) left_out.add(left[worker].count, left[worker].from_m);
  }
  cut(all, max_pairs_ - std::min(max_pairs_, reported), left_out);
  for (const Found& of : all) {
    events.push_back(of.event);
    if (of.goes_on) silent_[of.silent].reported.push_back(of.other);
  }
  std::erase_if(silent_, [](const Silent& silent) { return !silent.goes_on(); });
  for (Silent& silent : silent_) {
    if (!std::is_sorted(silent.reported.begin(), silent.reported.end())) {
      std::sort(silent.reported.begin(), silent.reported.end());
    }
  }
  return left_out;
}

void LivePossible::forget(AgentId bee) {
  for (Silent& silent : silent_) {
    const auto at = std::lower_bound(silent.reported.begin(), silent.reported.end(), bee);
    if (at != silent.reported.end() && *at == bee) silent.reported.erase(at);
  }
}

}  // namespace beespace::motion
