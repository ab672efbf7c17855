#include "motion/live/live_possible.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace beespace::motion {

namespace {

// More than anything that is rounded here.
constexpr double kUpward = 1.0 + 0x1p-40;

double age_s(const Fix& last, double now_s) {
  return std::abs(now_s - last.time_s);
}

// By how much the distance of two must be bridged before they are in conflict, in one direction;
// and whether both balls bridge it.
struct Bridge {
  double distance;
  double threshold;
  double largest;  // what was subtracted

  [[nodiscard]] double gap() const { return distance - threshold; }
  [[nodiscard]] bool closed(double grown) const {
    return distance < (threshold + grown) * kUpward + 0x1p-44 * largest;
  }
};

double largest_of(const Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace

std::vector<LivePossible::Heard> LivePossible::heard_of(const LiveBees& bees) {
  std::vector<Heard> heard;
  heard.reserve(bees.known().size());
  for (const auto& [id, bee] : bees.known()) {
    if (bee.stale()) {
      heard.push_back({id, bee.last, bee.height_m, true});
      continue;
    }
    const LiveRun& run = bees.runs()[bee.run];
    heard.push_back(
        {id, run.fixes.back(), run.heights_m.empty() ? 0.0 : run.heights_m.back(), false});
  }
  std::sort(heard.begin(), heard.end(),
            [](const Heard& a, const Heard& b) { return a.bee < b.bee; });
  return heard;
}

// Silences that are over are forgotten, new ones begun; and whoever was removed is forgotten.
void LivePossible::follow(const std::vector<Heard>& heard) {
  auto before = std::exchange(silent_, {});
  auto known = before.begin();
  for (const Heard& bee : heard) {
    if (!bee.stale) continue;
    while (known != before.end() && known->bee < bee.bee) ++known;
    const bool goes_on =
        known != before.end() && known->bee == bee.bee && known->since_s == bee.last.time_s;
    if (goes_on) {
      silent_.push_back(std::move(*known));
    } else {
      silent_.push_back({bee.bee, bee.last.time_s, {}});
    }
  }
}

void LivePossible::probe_neighbors(const Heard& stale, Silent& silent,
                                   const std::vector<Heard>& heard, double now_s,
                                   std::vector<SwarmEvent>& found) const {
  // All but itself, and of two that are stale it is the lower one that tells.
  silent.unsaid = 0;
  std::vector<PointId> still;
  still.reserve(silent.said.size());
  auto said = silent.said.begin();
  const Point& p = stale.last.position;
  for (const Heard& other : heard) {
    while (said != silent.said.end() && *said < other.bee) ++said;
    if (said != silent.said.end() && *said == other.bee) {
      still.push_back(other.bee);
      continue;
    }
    if (other.bee == stale.bee || (other.stale && other.bee < stale.bee)) continue;
    ++silent.unsaid;
    const Point& q = other.last.position;
    const double grown_m = max_speed_mps_ * (age_s(stale.last, now_s) + age_s(other.last, now_s));
    const double x = q.x - p.x;
    const double y = q.y - p.y;
    const double z = q.z - p.z;
    const double largest = std::max(largest_of(p), largest_of(q));
    const bool level = enter_.vertical_m && !enter_.heights_apart;
    const Bridge across{std::sqrt(x * x + y * y + (level ? 0.0 : z * z)), enter_.threshold_m,
                        largest};
    if (!across.closed(grown_m)) continue;
    double gap_m = across.gap();
    double rise_m = level ? z : 0.0;
    if (enter_.vertical_m) {
      const double unit_m = enter_.heights_apart ? enter_.height_unit_m : 1.0;
      const double rise = enter_.heights_apart ? other.height_m - stale.height_m : z;
      const Bridge up{std::abs(rise), *enter_.vertical_m,
                      std::max({largest, std::abs(other.height_m), std::abs(stale.height_m)})};
      if (!up.closed(grown_m / unit_m)) continue;
      gap_m = std::max(gap_m, up.gap() * unit_m);
      rise_m = rise * unit_m;
    }
    const double latest_s = std::max(stale.last.time_s, other.last.time_s);
    double since_s = latest_s;
    if (gap_m > 0.0 && max_speed_mps_ > 0.0) {
      const double middle_s = 0.5 * (stale.last.time_s + other.last.time_s);
      since_s =
          std::clamp(middle_s + 0.5 * gap_m / max_speed_mps_, latest_s, std::max(latest_s, now_s));
    }
    const double silent_since_s =
        other.stale ? std::min(stale.last.time_s, other.last.time_s) : stale.last.time_s;
    found.push_back({EventKind::kPossible, since_s, std::min(stale.bee, other.bee),
                     std::max(stale.bee, other.bee), std::hypot(across.distance, rise_m), since_s,
                     silent_since_s});
  }
  silent.said = std::move(still);
}

LeftOut LivePossible::tell(const LiveBees& bees, double now_s, const core::Resources& with,
                           std::vector<SwarmEvent>& events) {
  LeftOut left_out;
  if (bees.stale() == 0) {
    silent_.clear();
    return left_out;
  }
  const std::vector<Heard> heard = heard_of(bees);
  follow(heard);
  const auto closer = [](const SwarmEvent& a, const SwarmEvent& b) {
    return std::tie(a.distance_m, a.first, a.second) < std::tie(b.distance_m, b.first, b.second);
  };
  // No more than the closest of what there is room for at most, and as many again.
  const auto cut = [&](std::vector<SwarmEvent>& found, std::size_t most, LeftOut& left) {
    if (found.size() <= most) return;
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(found.begin(), end, found.end(), closer);
    left.add(found.size() - most, end->distance_m);
    found.resize(most);
  };
  const std::size_t workers = with.crew.size();
  std::vector<std::vector<SwarmEvent>> found(workers);
  std::vector<LeftOut> left(workers);
  with.crew.split(silent_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      Silent& silent = silent_[i];
      const auto stale =
          std::lower_bound(heard.begin(), heard.end(), silent.bee,
                           [](const Heard& bee, PointId id) { return bee.bee < id; });
      if (silent.all_said_at == bees.changes()) continue;
      probe_neighbors(*stale, silent, heard, now_s, found[worker]);
      silent.all_said_at = silent.unsaid == 0 ? bees.changes() : 0;
      if (found[worker].size() > 2 * max_pairs_) cut(found[worker], max_pairs_, left[worker]);
    }
  });
  std::size_t said = 0;
  for (const Silent& silent : silent_) said += silent.said.size();
  std::vector<SwarmEvent> all;
  for (std::size_t worker = 0; worker < workers; ++worker) {
    all.insert(all.end(), found[worker].begin(), found[worker].end());
    if (left[worker].any) left_out.add(left[worker].count, left[worker].from_m);
  }
  cut(all, max_pairs_ - std::min(max_pairs_, said), left_out);
  for (const SwarmEvent& event : all) remember(event);
  for (Silent& silent : silent_) {
    if (!std::is_sorted(silent.said.begin(), silent.said.end())) {
      std::sort(silent.said.begin(), silent.said.end());
    }
  }
  events.insert(events.end(), all.begin(), all.end());
  return left_out;
}

void LivePossible::forget(PointId bee) {
  for (Silent& silent : silent_) {
    const auto at = std::lower_bound(silent.said.begin(), silent.said.end(), bee);
    if (at != silent.said.end() && *at == bee) silent.said.erase(at);
  }
}

// The lower one of two that are stale knows what has been said; otherwise the stale one does.
void LivePossible::remember(const SwarmEvent& event) {
  const auto silence_of = [&](PointId bee) {
    const auto at = std::lower_bound(silent_.begin(), silent_.end(), bee,
                                     [](const Silent& a, PointId id) { return a.bee < id; });
    return at != silent_.end() && at->bee == bee ? &*at : nullptr;
  };
  Silent* silent = silence_of(event.first);
  const PointId other = silent != nullptr ? event.second : event.first;
  if (silent == nullptr) silent = silence_of(event.second);
  silent->said.push_back(other);
}

}  // namespace beespace::motion
