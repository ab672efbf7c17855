#include "guide/contract_monitor.hpp"

#include "fleet/correction_loop.hpp"
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::guide {
namespace {

using core::Vector3;
using scenes::RandomStream;

constexpr FlightLimits kLimits{10.0, 5.0};
constexpr LinkFigures kLink{.period_s = 0.1, .command_delay = 2, .longest_loss = 0};

// A fleet on board, which reports each tick, a tick late.
FleetFigures usual_figures() {
  return {.report_error_m = 0.2,
          .report_age_s = 0.2,
          .sensing_error_m = 0.05,
          .loop_period_s = 0.02,
          .deviation_mps = 0.3,
          .correction_mps2 = 1.0,
          .correction_mps = 1.0};
}

Tube tube_for(const FleetFigures& figures) {
  const Result<Tube> tube = tube_of(figures, kLink, kLimits);
  EXPECT_TRUE(tube);
  return tube.value_or(Tube{});
}

ContractMonitor monitor_of(const FleetFigures& figures) {
  return {figures, kLink, tube_for(figures)};
}

Vector3 direction(RandomStream& random) {
  return core::vector_of(scenes::random_direction(random));
}

Point point_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

AgentReport report_at(Tick tick, const Vector3& place, double after_s = 0.0) {
  AgentReport report;
  report.held = 1;
  report.tick = tick;
  report.after_s = after_s;
  report.position = point_of(place);
  return report;
}

TEST(ContractMonitor, AnAgentThatIsWhereItShouldBeKeepsItsContract) {
  ContractMonitor monitor = monitor_of(usual_figures());
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  EXPECT_EQ(monitor.reason(), ContractReason::kNone);
  EXPECT_EQ(monitor.deviation_m(), 0.0);
  monitor.take({10.0, 0.0, 0.0}, report_at(3, {10.0, 0.1, 0.0}), 0.1);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  EXPECT_DOUBLE_EQ(monitor.deviation_m(), 0.1);
}

TEST(ContractMonitor, BeyondItsTubeAndTheErrorOfReportsItIsOut) {
  const FleetFigures figures = usual_figures();
  const double out_m = tube_for(figures).radius_m + figures.report_error_m;
  ContractMonitor within = monitor_of(figures);
  within.take({}, report_at(0, {0.0, 0.0, out_m}), 0.0);
  EXPECT_EQ(within.contract(), Contract::kDoubted);
  ContractMonitor beyond = monitor_of(figures);
  beyond.take({}, report_at(0, {0.0, 0.0, out_m * (1.0 + 1e-9)}), 0.0);
  EXPECT_EQ(beyond.contract(), Contract::kOut);
  EXPECT_EQ(beyond.reason(), ContractReason::kDeviation);
}

TEST(ContractMonitor, ItIsDoubtedWhereItMayHaveLeftItsTubeSinceTheReport) {
  const FleetFigures figures = usual_figures();
  const double tube_m = tube_for(figures).radius_m;
  // It may be off by 0.2 m more, and go 1.3 m/s.
  const Vector3 place{tube_m - 0.2 - 0.13 - 0.001, 0.0, 0.0};
  ContractMonitor monitor = monitor_of(figures);
  monitor.take({}, report_at(5, place), 0.1);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  monitor.take({}, report_at(6, place), 0.12);
  EXPECT_EQ(monitor.contract(), Contract::kDoubted);
  EXPECT_EQ(monitor.reason(), ContractReason::kDeviation);
  monitor.take({}, report_at(7, place), 0.1);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
}

TEST(ContractMonitor, ADeviationThatChangesTooFastNamesTheAgent) {
  const FleetFigures figures = usual_figures();
  // In a tick 0.13 m; and twice the error of reports.
  ContractMonitor slow = monitor_of(figures);
  slow.take({}, report_at(0, {-0.26, 0.0, 0.0}), 0.1);
  slow.take({}, report_at(1, {0.26, 0.0, 0.0}), 0.1);
  EXPECT_NE(slow.contract(), Contract::kOut);
  ContractMonitor fast = monitor_of(figures);
  fast.take({}, report_at(0, {-0.27, 0.0, 0.0}), 0.1);
  fast.take({}, report_at(1, {0.27, 0.0, 0.0}), 0.1);
  EXPECT_EQ(fast.contract(), Contract::kOut);
  EXPECT_EQ(fast.reason(), ContractReason::kRate);
}

// What two reports in succession hide in their errors, more of them show.
TEST(ContractMonitor, ADeviationThatChangesTooFastForLongNamesTheAgentAsWell) {
  FleetFigures figures = usual_figures();
  figures.report_error_m = 1.0;  // so wide a tube that it stays in it
  figures.correction_mps = 0.7;
  // At 3.2 m/s instead of 1: 2 m more after ten ticks.
  ContractMonitor fast = monitor_of(figures);
  for (Tick tick = 0; tick < 12; ++tick) {
    const double x = -1.4 + 0.32 * static_cast<double>(tick);
    if (fast.contract() != Contract::kOut) fast.take({}, report_at(tick, {x, 0.0, 0.0}), 0.1);
  }
  EXPECT_EQ(fast.reason(), ContractReason::kRate);
}

TEST(ContractMonitor, AnAgentThatIsOutStaysOutForTheFirstReason) {
  ContractMonitor monitor = monitor_of(usual_figures());
  monitor.name(ContractReason::kNoBranch);
  monitor.take({}, report_at(1, {9.0, 0.0, 0.0}), 0.1);
  monitor.take({}, report_at(2, {}), 0.1);
  monitor.check_silence(100.0);
  monitor.name(ContractReason::kFuture);
  EXPECT_EQ(monitor.contract(), Contract::kOut);
  EXPECT_EQ(monitor.reason(), ContractReason::kNoBranch);
  monitor = monitor_of(usual_figures());
  EXPECT_EQ(monitor.contract(), Contract::kKept);
}

TEST(ContractMonitor, OnBoardASilentAgentIsDoubtedUntilItReports) {
  const FleetFigures figures = usual_figures();
  ContractMonitor monitor(figures, {.period_s = 0.1, .longest_loss = 3}, tube_for(figures));
  monitor.check_silence(0.5);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  monitor.check_silence(0.51);
  EXPECT_EQ(monitor.contract(), Contract::kDoubted);
  EXPECT_EQ(monitor.reason(), ContractReason::kSilent);
  monitor.take({}, report_at(9, {}), 0.1);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
}

TEST(ContractMonitor, OnTheGroundASilentAgentIsOut) {
  FleetFigures figures = usual_figures();
  figures.loop = LoopPlace::kGround;
  ContractMonitor monitor = monitor_of(figures);
  monitor.check_silence(0.2);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  monitor.check_silence(0.21);
  EXPECT_EQ(monitor.contract(), Contract::kOut);
  EXPECT_EQ(monitor.reason(), ContractReason::kSilent);
}

TEST(ContractMonitor, ALateReportTellsOfThePastAndNotOfNow) {
  const FleetFigures figures = usual_figures();
  ContractMonitor monitor = monitor_of(figures);
  monitor.take({}, report_at(10, {0.05, 0.0, 0.0}), 0.1);
  monitor.take({}, report_at(4, {0.3, 0.0, 0.0}), 0.7);
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  EXPECT_DOUBLE_EQ(monitor.deviation_m(), 0.05);
  monitor.take({}, report_at(10, {0.05, 0.0, 0.0}), 5.0);  // once more
  EXPECT_EQ(monitor.contract(), Contract::kKept);
  monitor.take({}, report_at(3, {30.0, 0.0, 0.0}), 0.8);
  EXPECT_EQ(monitor.contract(), Contract::kOut);
}

TEST(ContractMonitor, APlaceThatIsNoNumberNamesTheAgent) {
  ContractMonitor monitor = monitor_of(usual_figures());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  monitor.take({}, report_at(0, {nan, 0.0, 0.0}), 0.1);
  EXPECT_EQ(monitor.contract(), Contract::kOut);
}

// The hardest that figures allow: it goes along the rim as fast as it may, its reports are as wrong
// as they may be, most of them outwards, and come late, doubled and in any order.
TEST(ContractMonitor, NoAgentIsNamedThatKeepsItsFigures) {
  RandomStream random(11);
  std::size_t doubted = 0;
  for (int agent = 0; agent < 500; ++agent) {
    FleetFigures figures = usual_figures();
    figures.report_error_m = random.uniform(0.0, 0.5);
    if (agent % 3 == 0) figures.loop = LoopPlace::kGround;
    if (agent % 5 == 0) figures.clock_error_s = 0.01;
    const double tube_m = tube_for(figures).radius_m;
    ContractMonitor monitor = monitor_of(figures);
    const double fastest_mps = figures.deviation_mps + figures.correction_mps;
    Vector3 off = direction(random) * tube_m;
    Vector3 way = direction(random);
    Vector3 nominal = direction(random) * 1e4;
    std::vector<AgentReport> sent;
    std::vector<Vector3> nominals;
    double at_s = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const double lasts_s = random.uniform(0.0, 0.2);
      at_s += lasts_s;
      if (random.index(10) == 0) way = random.index(2) == 0 ? -way : direction(random);
      off = core::at_most(off + way * (fastest_mps * lasts_s), tube_m);
      nominal = nominal + direction(random) * (9.0 * lasts_s);
      const auto tick = static_cast<Tick>(at_s / 0.1);
      const Vector3 wrong =
          random.index(3) == 0 ? direction(random) : off * (1.0 / core::length(off));
      sent.push_back(report_at(tick, nominal + off + wrong * figures.report_error_m,
                               at_s - static_cast<double>(tick) * 0.1));
      nominals.push_back(nominal);
      const std::size_t back = random.index(4) == 0 ? random.index(6) : 0;
      const std::size_t which = sent.size() - 1 - std::min(back, sent.size() - 1);
      monitor.take(point_of(nominals[which]), sent[which], 0.1);
      if (monitor.contract() == Contract::kDoubted) ++doubted;
      ASSERT_NE(monitor.contract(), Contract::kOut)
          << agent << " " << k << " " << static_cast<int>(monitor.reason());
    }
  }
  EXPECT_GT(doubted, 100000u);  // it is at the rim
}

// A flight of an agent whose motors have a share of the strength that was stated: it follows a
// nominal path that turns all the time, corrects on board, and reports each tick.
class WeakFlight {
 public:
  WeakFlight(const FleetFigures& figures, double strength, std::uint64_t seed)
      : figures_(figures),
        loop_(tube_for(figures), figures, 0.02),
        strength_(strength),
        random_(seed),
        wind_(direction(random_) * figures.deviation_mps) {}

  // Flies a tick, of five periods of the loop.
  void fly() {
    if (random_.index(8) == 0) goal_ = direction(random_) * 9.0;
    const Vector3 change = core::at_most(goal_ - nominal_velocity_, 0.4);
    for (int k = 0; k < 5; ++k) {
      const Vector3 known = place_ - nominal_ + direction(random_) * figures_.sensing_error_m;
      const Vector3 corrected = loop_.next(known, velocity_ - nominal_velocity_);
      const Vector3 next = nominal_velocity_ + change * 0.2;
      nominal_ = nominal_ + (nominal_velocity_ + next) * 0.01;
      const Vector3 wanted = next + corrected - velocity_;
      const Vector3 after = velocity_ + core::at_most(wanted, strength_ * 5.0 * 0.02);
      place_ = place_ + (velocity_ + after) * 0.01 + wind_ * 0.02;
      velocity_ = after;
      nominal_velocity_ = next;
    }
    ++tick_;
  }

  [[nodiscard]] AgentReport report() {
    return report_at(tick_, place_ + direction(random_) * figures_.report_error_m);
  }
  [[nodiscard]] Point nominal() const { return point_of(nominal_); }
  [[nodiscard]] double deviation_m() const { return core::length(place_ - nominal_); }

 private:
  FleetFigures figures_;
  fleet::CorrectionLoop loop_;
  double strength_;
  RandomStream random_;
  Vector3 wind_;
  Tick tick_ = 0;
  Vector3 goal_;
  Vector3 nominal_;
  Vector3 nominal_velocity_;
  Vector3 place_;
  Vector3 velocity_;
};

struct Named {
  int all = 0;
  int by_rate = 0;
  int in_tube = 0;  // before they have left it
};

// Reports come a tick later. So an agent is named within their age and a period of passing the
// threshold: by the first report from beyond it.
Named name_weak(const FleetFigures& figures) {
  const double tube_m = tube_for(figures).radius_m;
  Named named;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    WeakFlight flight(figures, 0.5, seed);
    ContractMonitor monitor = monitor_of(figures);
    for (int tick = 0; tick < 400 && monitor.contract() != Contract::kOut; ++tick) {
      flight.fly();
      monitor.take(flight.nominal(), flight.report(), 0.1);
      EXPECT_TRUE(flight.deviation_m() <= tube_m + 2.0 * figures.report_error_m ||
                  monitor.contract() == Contract::kOut)
          << seed;
    }
    if (monitor.contract() != Contract::kOut) continue;
    ++named.all;
    if (monitor.reason() == ContractReason::kRate) ++named.by_rate;
    if (flight.deviation_m() <= tube_m) ++named.in_tube;
  }
  return named;
}

TEST(ContractMonitor, AWeakMotorIsNamedByTheFirstReportBeyondTheThreshold) {
  EXPECT_GT(name_weak(usual_figures()).all, 290);
}

TEST(ContractMonitor, WhereTubesAreWideTheRateNamesAWeakMotorBeforeItIsOut) {
  FleetFigures figures = usual_figures();
  figures.report_error_m = 0.05;
  figures.deviation_mps = 0.5;
  figures.correction_mps = 0.7;
  figures.correction_mps2 = 0.2;
  const Named named = name_weak(figures);
  EXPECT_GT(named.all, 290);
  EXPECT_GT(named.by_rate, 200);
  EXPECT_GT(named.in_tube, 150);
}

TEST(ContractMonitor, TheSameFlightWithTheStatedStrengthIsNotNamed) {
  const FleetFigures figures = usual_figures();
  const double tube_m = tube_for(figures).radius_m;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    WeakFlight flight(figures, 1.0, seed);
    ContractMonitor monitor = monitor_of(figures);
    for (int tick = 0; tick < 400; ++tick) {
      flight.fly();
      monitor.take(flight.nominal(), flight.report(), 0.1);
      ASSERT_LE(flight.deviation_m(), tube_m) << seed;
      ASSERT_NE(monitor.contract(), Contract::kOut) << seed;
    }
  }
}

}  // namespace
}  // namespace beespace::guide
