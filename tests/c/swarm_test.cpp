// A swarm of C says what one of C++ says to the same reports: of agents that fall silent, are late,
// repeat or contradict themselves, are removed and lost; with all options.
#include "tests/c/c_swarms.hpp"
#include "tests/support/rounds.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Ascending, of both signs: C++ knows agent k where C knows id_of_agent(k).
std::int64_t id_of_agent(AgentId agent) {
  constexpr std::array<std::int64_t, 4> kEnds = {std::numeric_limits<std::int64_t>::min(), -7, 0,
                                                 std::numeric_limits<std::int64_t>::max()};
  return agent < 3     ? kEnds[agent]
         : agent == 99 ? kEnds[3]
                       : static_cast<std::int64_t>(agent) * 1000;
}

struct Pace {
  SwarmOptions options;
  beespace_swarm_options given;
};

Pace random_pace(std::mt19937_64& random) {
  const auto chance = [&](double part) { return std::bernoulli_distribution(part)(random); };
  Pace pace{{}, c_swarm_options(5.0)};
  pace.options.threshold_m = 5.0;
  if (chance(0.5)) {
    pace.options.vertical_m = pace.given.vertical_m = 3.0;
    pace.given.flags |= BEESPACE_SWARM_VERTICAL;
    if (chance(0.5)) {
      pace.options.heights_apart = true;
      pace.given.flags |= BEESPACE_SWARM_HEIGHTS_APART;
      pace.options.height_unit_m = pace.given.height_unit_m = 0.3048;
    }
  }
  if (chance(0.5)) pace.options.leave_factor = pace.given.leave_factor = 1.5;
  if (chance(0.5)) {
    pace.options.horizon_s = pace.given.horizon_s = chance(0.5) ? 0.0 : 4.0;
    pace.given.flags |= BEESPACE_SWARM_HORIZON;
  }
  if (chance(0.7)) pace.options.max_age_s = pace.given.max_age_s = 2.0;
  if (chance(0.5)) {
    pace.options.max_speed_mps = pace.given.max_speed_mps = 6.0;
    pace.given.flags |= BEESPACE_SWARM_MAX_SPEED;
  }
  if (chance(0.3)) pace.options.max_agents = pace.given.max_agents = 8;
  if (chance(0.3)) pace.options.max_pairs = pace.given.max_pairs = 2;
  pace.given.threads = chance(0.3) ? 2 : 0;
  return pace;
}

// A flock in a small box, and how it is heard.
class Flock {
 public:
  explicit Flock(std::mt19937_64& random) : random_(random) {
    for (AgentId agent = 0; agent < 10; ++agent) bees_.push_back({agent, place(), drift(), 0.0});
    bees_.push_back({99, place(), drift(), 0.0});
  }
  struct Heard {
    AgentId agent;
    CReport report;
  };
  // What is heard until a time: some of it twice, some of it late, some of it elsewhere.
  std::vector<Heard> hear_until(double time_s) {
    std::vector<Heard> heard;
    for (Bee& bee : bees_) {
      if (chance(0.02)) bee.silent_until_s = time_s + 5.0;
      if (chance(0.1)) bee.velocity = drift();
      if (time_s < bee.silent_until_s || chance(0.2)) continue;
      CReport report{
          id_of_agent(bee.agent),
          time_s - uniform(0.0, 0.3),
          {bee.from.x + bee.velocity.x * time_s, bee.from.y + bee.velocity.y * time_s, bee.from.z},
          {bee.velocity.x, bee.velocity.y, 0.0},
          uniform(0.0, 20.0),
          uniform(-1.0, 1.0)};
      if (chance(0.5)) std::fill_n(report.velocity, 3, kUnknown);
      heard.push_back({bee.agent, report});
      if (chance(0.1)) heard.push_back(heard.back());
      if (chance(0.05)) {
        heard.push_back(heard.back());
        heard.back().report.position.x += 1.0;
      }
      if (chance(0.05)) late_.push_back(heard.back());
    }
    if (chance(0.3)) {
      heard.insert(heard.end(), late_.begin(), late_.end());
      late_.clear();
    }
    std::shuffle(heard.begin(), heard.end(), random_);
    return heard;
  }

 private:
  struct Bee {
    AgentId agent;
    Point from;
    Velocity velocity;
    double silent_until_s;
  };
  bool chance(double part) { return std::bernoulli_distribution(part)(random_); }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Point place() { return {uniform(0, 15), uniform(0, 15), uniform(0, 5)}; }
  Velocity drift() { return {uniform(-1, 1), uniform(-1, 1), 0.0}; }

  std::mt19937_64& random_;
  std::vector<Bee> bees_;
  std::vector<Heard> late_;
};

class CSwarm : public testing::Test {
 protected:
  void begin(const Pace& pace) {
    beespace_swarm* made = nullptr;
    ASSERT_EQ(beespace_swarm_create(&pace.given, &made, &error_), BEESPACE_OK) << error_.message;
    swarm_.reset(made);
    heights_apart_ = pace.options.heights_apart;
  }
  // Into both; they refuse the same.
  void tell(Swarm& swarm, const std::vector<Flock::Heard>& heard) {
    std::int64_t refused = 0;
    std::int64_t first = -1;
    std::vector<CReport> reports;
    for (const Flock::Heard& each : heard) {
      if (!swarm.update(report_of(each.report, each.agent))) {
        ++refused;
        if (first < 0) first = static_cast<std::int64_t>(reports.size());
      }
      reports.push_back(each.report);
    }
    const CReports given(reports, heights_apart_);
    std::int64_t told = -2;
    const beespace_code code = beespace_swarm_update(swarm_.get(), &given.fixes, &given.positions,
                                                     &given.velocities, &told, &error_);
    EXPECT_EQ(told, refused);
    EXPECT_EQ(code, refused == 0 ? BEESPACE_OK : BEESPACE_TOO_MANY_POINTS);
    if (refused == 0) return;
    EXPECT_EQ(error_.record, first);
    EXPECT_STREQ(error_.place, "agents");
  }
  void expect_events(const std::vector<SwarmEvent>& expected) {
    const beespace_events* const events = events_.get();
    ASSERT_EQ(beespace_events_size(events), static_cast<std::int64_t>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const SwarmEvent& event = expected[i];
      EXPECT_EQ(beespace_events_kinds(events)[i], static_cast<std::int32_t>(event.kind));
      EXPECT_EQ(beespace_events_times_s(events)[i], event.time_s);
      const bool pairs_bound =
          event.kind == EventKind::kOverloaded && event.bound != SwarmBound::kAgents;
      EXPECT_EQ(beespace_events_first(events)[i], pairs_bound ? 0 : id_of_agent(event.first));
      EXPECT_EQ(beespace_events_second(events)[i], pairs_bound ? 0 : id_of_agent(event.second));
      EXPECT_EQ(beespace_events_distances_m(events)[i], event.distance_m);
      EXPECT_EQ(beespace_events_closest_s(events)[i], event.closest_s);
      EXPECT_EQ(beespace_events_left_out(events)[i], static_cast<std::int64_t>(event.count));
      EXPECT_EQ(beespace_events_bounds(events)[i], static_cast<std::int32_t>(event.bound));
      const double since_s = beespace_events_since_s(events)[i];
      seen_.insert(name_at(i));
      if (std::isnan(since_s)) {
        unsilent_.insert(name_at(i));
      } else {
        EXPECT_EQ(since_s, event.since_s);
      }
    }
  }
  void expect_known(const Swarm& swarm, double time_s) {
    Owned<beespace_movers> movers(beespace_movers_create());
    ASSERT_EQ(beespace_swarm_movers(swarm_.get(), time_s, movers.get(), &error_), BEESPACE_OK);
    const std::vector<LiveMover> expected = swarm.movers(time_s);
    ASSERT_EQ(beespace_movers_size(movers.get()), static_cast<std::int64_t>(expected.size()));
    const auto point = [](const double* from, std::size_t i) {
      return Point{from[3 * i], from[3 * i + 1], from[3 * i + 2]};
    };
    double unknown_s = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const LiveMover& mover = expected[i];
      EXPECT_EQ(beespace_movers_ids(movers.get())[i], id_of_agent(mover.id));
      EXPECT_EQ(point(beespace_movers_positions(movers.get()), i), mover.mover.position);
      const Velocity v = mover.mover.velocity;
      EXPECT_EQ(point(beespace_movers_velocities(movers.get()), i), (Point{v.x, v.y, v.z}));
      EXPECT_EQ(point(beespace_movers_heard_at(movers.get()), i), mover.heard_at);
      EXPECT_EQ(beespace_movers_heard_s(movers.get())[i], mover.heard_s);
      EXPECT_EQ(beespace_movers_stale(movers.get())[i], mover.stale ? 1 : 0);
      EXPECT_EQ(beespace_movers_move(movers.get())[i], mover.moves ? 1 : 0);
      unknown_s += beespace_movers_unknown_s(movers.get())[i];
    }
    double silent_s = 0.0;
    for (const Silence& silence : swarm.silences(time_s)) silent_s += silence.unknown_s;
    EXPECT_EQ(unknown_s, silent_s);
  }
  void expect_counts(const Swarm& swarm) {
    beespace_counts counts{};
    counts.struct_size = sizeof counts;
    ASSERT_EQ(beespace_swarm_counts(swarm_.get(), &counts, &error_), BEESPACE_OK);
    const SwarmCounts expected = swarm.counts();
    EXPECT_EQ(counts.taken, expected.taken);
    EXPECT_EQ(counts.repeated, expected.repeated);
    EXPECT_EQ(counts.late, expected.late);
    EXPECT_EQ(counts.contrary, expected.contrary);
    EXPECT_EQ(counts.refused, expected.refused);
    EXPECT_EQ(counts.agents, expected.agents);
    EXPECT_EQ(counts.stale, expected.stale);
    EXPECT_EQ(counts.heard_once, expected.heard_once);
    EXPECT_EQ(counts.predicted, expected.predicted);
    EXPECT_EQ(counts.unknown_s, expected.unknown_s);
    EXPECT_EQ(counts.missed_s, expected.missed_s);
    sum_.late += counts.late;
    sum_.repeated += counts.repeated;
    sum_.contrary += counts.contrary;
    sum_.refused += counts.refused;
  }
  [[nodiscard]] std::string name_at(std::size_t i) const {
    return beespace_event_name(beespace_events_kinds(events_.get())[i]);
  }

  bool heights_apart_ = false;
  Owned<beespace_swarm> swarm_;
  Owned<beespace_events> events_{beespace_events_create()};
  beespace_error error_ = c_error();
  std::set<std::string> seen_;
  std::set<std::string> unsilent_;  // kinds without a silence
  SwarmCounts sum_;
};

TEST_F(CSwarm, SaysWhatTheOneOfCppSays) {
  std::mt19937_64 random(4711);
  for (int round = 0; round < rounds(60); ++round) {
    SCOPED_TRACE(round);
    const Pace pace = random_pace(random);
    begin(pace);
    Swarm swarm(pace.options);
    std::optional<Flock> flock(random);
    double time_s = 0.0;
    for (int step = 0; step < 40; ++step) {
      time_s += 0.5;
      tell(swarm, flock->hear_until(time_s));
      const AgentId agent = step % 10 == 3 ? 4 : 99;
      const std::array<std::int64_t, 2> ids = {id_of_agent(agent), 123'456};
      if (step % 10 == 3) {
        swarm.remove(agent);
        ASSERT_EQ(beespace_swarm_remove(swarm_.get(), ids.data(), 2, &error_), BEESPACE_OK);
      } else if (step % 10 == 7) {
        swarm.lose(agent);
        ASSERT_EQ(beespace_swarm_lose(swarm_.get(), ids.data(), 2, &error_), BEESPACE_OK);
      }
      if (step == 25) {
        const Result<std::vector<SwarmEvent>> anew = swarm.begin_anew(time_s, -3.0);
        ASSERT_EQ(beespace_swarm_begin_anew(swarm_.get(), time_s, -3.0, events_.get(), &error_),
                  BEESPACE_OK);
        expect_events(*anew);
        time_s = -3.0;
        flock.emplace(random);
      }
      const Result<std::vector<SwarmEvent>> events = swarm.advance(time_s);
      ASSERT_TRUE(events) << events.error().message;
      ASSERT_EQ(beespace_swarm_advance(swarm_.get(), time_s, events_.get(), &error_), BEESPACE_OK)
          << error_.message;
      expect_events(*events);
      expect_known(swarm, time_s + 0.1);
      expect_counts(swarm);
    }
    const Result<std::vector<SwarmEvent>> events = swarm.finish(time_s);
    ASSERT_EQ(beespace_swarm_finish(swarm_.get(), time_s, events_.get(), &error_), BEESPACE_OK);
    expect_events(*events);
    expect_counts(swarm);
  }
  if (kSanitized) return;  // too few rounds for all that may happen
  EXPECT_EQ(seen_,
            (std::set<std::string>{"predicted", "possible", "heard", "entered", "closest_passed",
                                   "left", "stale", "lost", "ended", "overloaded"}));
  EXPECT_EQ(unsilent_, (std::set<std::string>{"predicted", "entered", "closest_passed", "left",
                                              "ended", "overloaded"}));
  EXPECT_GT(sum_.late, 0U);
  EXPECT_GT(sum_.repeated, 0U);
  EXPECT_GT(sum_.contrary, 0U);
  EXPECT_GT(sum_.refused, 0U);
}

TEST_F(CSwarm, NumbersHaveNamesAndOthersNone) {
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_PREDICTED), "predicted");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_POSSIBLE), "possible");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_HEARD), "heard");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_ENTERED), "entered");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_CLOSEST_PASSED), "closest_passed");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_LEFT), "left");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_STALE), "stale");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_LOST), "lost");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_ENDED), "ended");
  EXPECT_STREQ(beespace_event_name(BEESPACE_EVENT_OVERLOADED), "overloaded");
  EXPECT_STREQ(beespace_event_name(-1), "unknown");
  EXPECT_STREQ(beespace_event_name(10), "unknown");
  EXPECT_STREQ(beespace_bound_name(BEESPACE_BOUND_NONE), "none");
  EXPECT_STREQ(beespace_bound_name(BEESPACE_BOUND_AGENTS), "agents");
  EXPECT_STREQ(beespace_bound_name(BEESPACE_BOUND_PAIRS), "pairs");
  EXPECT_STREQ(beespace_bound_name(BEESPACE_BOUND_PREDICTED), "predicted");
  EXPECT_STREQ(beespace_bound_name(BEESPACE_BOUND_POSSIBLE), "possible");
  EXPECT_STREQ(beespace_bound_name(5), "unknown");
}

}  // namespace
}  // namespace beespace::test
