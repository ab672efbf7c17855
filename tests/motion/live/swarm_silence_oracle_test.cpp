// Random swarms with silences, compared with the definition: between two reports at most max_age_s
// apart a bee flies straight, at a single report it is there for an instant, and all other times
// are unknown. The oracle shares no code with the library: for each pair of bees and of pieces it
// solves the quadratic in long double.
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"
#include "tests/support/swarm_replay.hpp"

#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using test::Events;
using Real = long double;

constexpr double kThreshold_m = 10.0;
constexpr double kLeave_m = 12.5;
constexpr double kMaxAge_s = 2.0;

// A stretch of time in which reports follow each other closely enough.
struct Known {
  std::vector<PositionReport> reports;
  bool silent = false;  // it was followed by a silence

  [[nodiscard]] double begins_s() const { return reports.front().time_s; }
  [[nodiscard]] double ends_s() const { return reports.back().time_s; }
};

struct Happened {
  std::string what;
  double time_s;
  AgentId first;
  AgentId second;
};

bool operator<(const Happened& a, const Happened& b) {
  return std::tie(a.first, a.second, a.time_s, a.what) <
         std::tie(b.first, b.second, b.time_s, b.what);
}

struct Vector {
  Real x, y, z;
};

Vector at(const Known& known, Real time_s) {
  std::size_t i = 0;
  while (i + 2 < known.reports.size() && known.reports[i + 1].time_s <= time_s) ++i;
  const Point& p = known.reports[i].position;
  if (known.reports.size() == 1) return {p.x, p.y, p.z};
  const Point& q = known.reports[i + 1].position;
  const Real from = known.reports[i].time_s;
  const Real share = (time_s - from) / (Real{known.reports[i + 1].time_s} - from);
  return {p.x + (Real{q.x} - p.x) * share, p.y + (Real{q.y} - p.y) * share,
          p.z + (Real{q.z} - p.z) * share};
}

Vector between(const Known& a, const Known& b, Real time_s) {
  const Vector p = at(a, time_s);
  const Vector q = at(b, time_s);
  return {q.x - p.x, q.y - p.y, q.z - p.z};
}

Real dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// When two in straight flight from `begin` to `end` cross a distance, in order.
std::vector<Real> crossings(const Known& a, const Known& b, Real begin, Real end, Real distance) {
  const Vector r = between(a, b, begin);
  const Vector s = between(a, b, end);
  const Vector w{s.x - r.x, s.y - r.y, s.z - r.z};
  const Real square = dot(w, w);
  const Real middle = dot(r, w);
  const Real discriminant = middle * middle - square * (dot(r, r) - distance * distance);
  if (square == 0 || discriminant <= 0) return {};
  std::vector<Real> times;
  for (const Real sign : {Real{-1}, Real{1}}) {
    const Real share = (-middle + sign * std::sqrt(discriminant)) / square;
    if (share > 0 && share < 1) times.push_back(begin + share * (end - begin));
  }
  return times;
}

// What happens between two while both are known.
void tell_pair(const Known& a, const Known& b, AgentId first, AgentId second,
               std::vector<Happened>& happened) {
  const double begin = std::max(a.begins_s(), b.begins_s());
  const double end = std::min(a.ends_s(), b.ends_s());
  if (begin > end) return;
  const auto near = [&](Real time_s, Real distance) {
    const Vector r = between(a, b, time_s);
    return dot(r, r) < distance * distance;
  };
  // Nothing changes but at these times.
  std::vector<Real> times = {begin, end};
  for (const Known* known : {&a, &b}) {
    for (const PositionReport& report : known->reports) {
      if (report.time_s > begin && report.time_s < end) times.push_back(report.time_s);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<std::pair<Real, bool>> changes;  // when, and whether by the leave threshold
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    for (const Real time_s : crossings(a, b, times[i], times[i + 1], kThreshold_m)) {
      changes.push_back({time_s, false});
    }
    for (const Real time_s : crossings(a, b, times[i], times[i + 1], kLeave_m)) {
      changes.push_back({time_s, true});
    }
  }
  std::sort(changes.begin(), changes.end());
  bool entered = near(begin, kThreshold_m);
  if (entered) happened.push_back({"entered", begin, first, second});
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Real next = i + 1 < changes.size() ? changes[i + 1].first : Real{end};
    const Real after = 0.5L * (changes[i].first + next);
    const auto time_s = static_cast<double>(changes[i].first);
    if (!entered && !changes[i].second && near(after, kThreshold_m)) {
      entered = true;
      happened.push_back({"entered", time_s, first, second});
    } else if (entered && changes[i].second && !near(after, kLeave_m)) {
      entered = false;
      happened.push_back({"left", time_s, first, second});
    }
  }
  if (entered) {
    happened.push_back({a.silent || b.silent ? "lost" : "ended", end, first, second});
  }
}

std::vector<Known> cut(const std::vector<PositionReport>& reports, double now_s) {
  std::vector<Known> known;
  for (const PositionReport& report : reports) {
    if (!known.empty() && report.time_s - known.back().ends_s() <= kMaxAge_s) {
      known.back().reports.push_back(report);
      continue;
    }
    if (!known.empty()) known.back().silent = true;
    known.push_back({{report}});
  }
  if (!known.empty() && now_s - known.back().ends_s() > kMaxAge_s) known.back().silent = true;
  return known;
}

std::vector<Happened> expected(const std::vector<std::vector<PositionReport>>& bees, double now_s) {
  std::vector<Happened> happened;
  std::vector<std::vector<Known>> known;
  for (AgentId id = 0; id < bees.size(); ++id) {
    known.push_back(cut(bees[id], now_s));
    for (std::size_t k = 0; k < known[id].size(); ++k) {
      const Known& part = known[id][k];
      if (part.silent) happened.push_back({"stale", part.ends_s(), id, id});
      if (k > 0) happened.push_back({"heard", part.begins_s(), id, id});
    }
  }
  for (AgentId i = 0; i < bees.size(); ++i) {
    for (AgentId j = i + 1; j < bees.size(); ++j) {
      for (const Known& a : known[i]) {
        for (const Known& b : known[j]) tell_pair(a, b, i, j, happened);
      }
    }
  }
  std::sort(happened.begin(), happened.end());
  return happened;
}

std::string word_of(EventKind kind) {
  switch (kind) {
    case EventKind::kEntered:
      return "entered";
    case EventKind::kLeft:
      return "left";
    case EventKind::kLost:
      return "lost";
    case EventKind::kEnded:
      return "ended";
    case EventKind::kStale:
      return "stale";
    case EventKind::kHeard:
      return "heard";
    default:
      return {};
  }
}

// Bees that turn now and then and are silent for a while, heard of at times of their own or all at
// once; some of them only once.
std::vector<std::vector<PositionReport>> reports_of(test::SceneMaker& make, bool ties) {
  std::vector<std::vector<PositionReport>> bees(2 + make.below(9));
  const double side_m = make.between(15.0, 60.0);
  for (AgentId id = 0; id < bees.size(); ++id) {
    Point at{make.between(0, side_m), make.between(0, side_m), make.between(0, 5)};
    Point speed{};
    const std::size_t most = make.below(6) == 0 ? 1 : 2 + make.below(30);
    double time_s = ties ? 0.5 * static_cast<double>(make.below(20)) : make.between(0, 10);
    while (bees[id].size() < most) {
      if (bees[id].empty() || make.below(4) == 0) {
        speed = {make.between(-8, 8), make.between(-8, 8), make.between(-1, 1)};
      }
      bees[id].push_back({id, time_s, at});
      double step_s = ties ? 0.5 * static_cast<double>(1 + make.below(4)) : make.between(0.1, 2.0);
      if (make.below(8) == 0) step_s += ties ? 2.0 : make.between(0.1, 8.0);
      time_s += step_s;
      at = {at.x + speed.x * step_s, at.y + speed.y * step_s, at.z + speed.z * step_s};
    }
  }
  return bees;
}

TEST(SwarmSilenceOracle, AgreesOnRandomSwarms) {
  test::SceneMaker make(2024);
  std::size_t event_count = 0;
  std::size_t lost = 0;
  for (int round = 0; round < test::rounds(1500); ++round) {
    SCOPED_TRACE(round);
    const bool ties = make.below(2) == 0;
    const auto bees = reports_of(make, ties);
    std::vector<PositionReport> all;
    for (const auto& bee : bees) all.insert(all.end(), bee.begin(), bee.end());
    std::stable_sort(all.begin(), all.end(), [](const PositionReport& a, const PositionReport& b) {
      return a.time_s < b.time_s;
    });
    SwarmOptions options{.threshold_m = kThreshold_m};
    options.leave_factor = kLeave_m / kThreshold_m;
    options.max_age_s = kMaxAge_s;
    options.horizon_s = make.below(2) == 0 ? 0.0 : 3.0;
    Swarm swarm(options);
    const double every_s = make.below(3) == 0 ? 1e9 : make.between(0.05, 4.0);
    double look_s = all.front().time_s;
    Events events;
    for (const PositionReport& report : all) {
      while (look_s < report.time_s) {
        test::take_all(swarm, look_s, events);
        look_s += every_s;
      }
      ASSERT_TRUE(swarm.update(report).has_value());
    }
    const double now_s = all.back().time_s;
    double silent_s = 0.0;
    test::take_all(swarm, now_s, events);
    for (const Silence& silence : swarm.silences(now_s)) silent_s += silence.unknown_s;
    const auto last = swarm.finish(now_s);
    ASSERT_TRUE(last.has_value());
    events.insert(events.end(), last->begin(), last->end());

    std::vector<Happened> happened;
    for (const SwarmEvent& event : events) {
      const std::string what = word_of(event.kind);
      if (!what.empty()) happened.push_back({what, event.time_s, event.first, event.second});
    }
    std::sort(happened.begin(), happened.end());
    const auto should = expected(bees, now_s);
    ASSERT_EQ(happened.size(), should.size());
    double unknown_s = 0.0;
    for (std::size_t k = 0; k < should.size(); ++k) {
      EXPECT_EQ(happened[k].what, should[k].what) << k;
      EXPECT_NEAR(happened[k].time_s, should[k].time_s, 1e-6) << k;
      EXPECT_EQ(happened[k].first, should[k].first);
      EXPECT_EQ(happened[k].second, should[k].second);
      if (should[k].what == "lost") ++lost;
      if (should[k].what == "stale") unknown_s -= should[k].time_s;
      if (should[k].what == "heard") unknown_s += should[k].time_s;
    }
    for (const auto& bee : bees) {
      if (now_s - bee.back().time_s > kMaxAge_s) unknown_s += now_s;
    }
    EXPECT_NEAR(silent_s, unknown_s, 1e-6);
    event_count += should.size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(event_count, static_cast<std::size_t>(test::rounds(10'000)));
  EXPECT_GT(lost, static_cast<std::size_t>(test::rounds(500)));
}

}  // namespace
}  // namespace beespace
