#include "io/recording/ground_claims.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kMinute_s = 60.0;
constexpr double kHalf_s = 30.0;  // so much of where it flew is kept, and up to twice as much
constexpr double kFastRoll_mps = 45.0;
constexpr double kLongRoll_mps = 25.0;  // for two minutes
constexpr double kStep_s = 10.0;
constexpr double kLevelRoll_mps = 1.0;
constexpr double kSteep_m = 100.0;
constexpr double kAboveFlight_m = 50.0;
constexpr double kLevel_m = 50.0;
constexpr double kLevelFor_s = 20.0;
constexpr double kSlowFlight_mps = 30.0;
constexpr double kLandedApart_s = 5.0;

double speed_between(const Fix& from, const Fix& to, Frame frame) {
  const Point apart = flat_offset_m(to.position, from.position, frame);
  return std::hypot(apart.x, apart.y) / (to.time_s - from.time_s);
}

}  // namespace

void GroundClaims::Stretch::add(const Fix& fix) {
  begins_s = std::min(begins_s, fix.time_s);
  ends_s = std::max(ends_s, fix.time_s);
  if (!(std::isfinite(fix.position.z))) return;
  low_m = std::min(low_m, fix.position.z);
  high_m = std::max(high_m, fix.position.z);
}

void GroundClaims::Stretch::add(const Stretch& other) {
  begins_s = std::min(begins_s, other.begins_s);
  ends_s = std::max(ends_s, other.ends_s);
  low_m = std::min(low_m, other.low_m);
  high_m = std::max(high_m, other.high_m);
}

GroundClaims::Run GroundClaims::run_of(const Aircraft& aircraft) {
  return {aircraft.claims,
          aircraft.in_flight,
          (aircraft.slow || aircraft.landed) && !aircraft.in_flight,
          aircraft.landed,
          aircraft.run.begins_s,
          aircraft.run.ends_s};
}

void GroundClaims::begin_run(Aircraft& aircraft, const Fix& fix) {
  aircraft.over = false;
  aircraft.in_flight = false;
  aircraft.fast = false;
  aircraft.slow = false;
  aircraft.anchor = fix;
  aircraft.step = fix;
  aircraft.window = {};
  aircraft.run = {};
  aircraft.before = aircraft.earlier;
  aircraft.before.add(aircraft.lately);
  aircraft.flew = aircraft.known;
  aircraft.flew_before = aircraft.last;
  aircraft.earlier = {};
  aircraft.lately = {};
}

void GroundClaims::claim(Aircraft& aircraft, const Fix& fix, Frame frame) {
  if (aircraft.claims++ == 0) begin_run(aircraft, fix);
  aircraft.run.add(fix);
  aircraft.window.add(fix);
  if (aircraft.window.high_m - aircraft.window.low_m > kSteep_m) aircraft.in_flight = true;
  if (!aircraft.landed && fix.time_s - aircraft.before.ends_s <= kMinute_s &&
      fix.position.z - aircraft.before.low_m > kAboveFlight_m) {
    aircraft.in_flight = true;
  }
  if (const double since_s = fix.time_s - aircraft.step.time_s; since_s >= kStep_s) {
    const double climb_m = std::abs(fix.position.z - aircraft.step.position.z);
    const bool level = !(climb_m > kLevelRoll_mps * since_s);  // also where no height is known
    if (level && speed_between(aircraft.step, fix, frame) < kLongRoll_mps) aircraft.slow = true;
    aircraft.step = fix;
  }
  if (fix.time_s - aircraft.anchor.time_s < kMinute_s) return;
  const double speed_mps = speed_between(aircraft.anchor, fix, frame);
  const bool fast = speed_mps > kLongRoll_mps;
  if (speed_mps > kFastRoll_mps || (fast && aircraft.fast)) aircraft.in_flight = true;
  aircraft.fast = fast;
  aircraft.anchor = fix;
  aircraft.window = {};
  aircraft.window.add(fix);
}

void GroundClaims::fly(Aircraft& aircraft, const Fix& fix, Frame frame) {
  aircraft.over = aircraft.claims > 0;
  if (aircraft.lately.lasts_s() > kHalf_s) {
    aircraft.earlier = aircraft.lately;
    aircraft.lately = {};
  }
  aircraft.lately.add(fix);
  if (!aircraft.over) return;
  if (!aircraft.landed && aircraft.run.high_m - aircraft.lately.low_m > kAboveFlight_m) {
    aircraft.in_flight = true;
  }
  Stretch all = aircraft.before;
  all.add(aircraft.run);
  all.add(aircraft.lately);
  const bool long_enough =
      aircraft.before.lasts_s() >= kLevelFor_s && aircraft.lately.lasts_s() >= kLevelFor_s;
  if (aircraft.flew && long_enough && all.high_m - all.low_m < kLevel_m &&
      speed_between(aircraft.flew_before, fix, frame) > kSlowFlight_mps) {
    aircraft.in_flight = true;
  }
}

void GroundClaims::take(std::string_view id, const Fix& fix, GroundClaim claims, Frame frame,
                        const Settle& settle) {
  const bool on_ground = claims != GroundClaim::kNone;
  auto place = aircraft_.find(id);
  if (place == aircraft_.end()) place = aircraft_.try_emplace(std::string(id)).first;
  auto& [name, aircraft] = *place;
  const double since_s = fix.time_s - aircraft.last.time_s;
  const bool anew = aircraft.known && !(since_s >= 0.0 && since_s <= kMinute_s);
  const bool judged = aircraft.over && (on_ground || fix.time_s - aircraft.run.ends_s > kMinute_s);
  const bool landed = claims == GroundClaim::kLanded;
  const bool other = on_ground && (landed != aircraft.landed ||
                                   (landed && fix.time_s - aircraft.run.ends_s > kLandedApart_s));
  if (aircraft.claims > 0 && (anew || judged || other)) {
    settle(name, run_of(aircraft));
    aircraft.claims = 0;
    aircraft.over = false;
  }
  if (anew) aircraft = {};
  if (on_ground) {
    if (aircraft.claims == 0) aircraft.landed = landed;
    claim(aircraft, fix, frame);
  } else {
    fly(aircraft, fix, frame);
  }
  aircraft.last = fix;
  aircraft.known = true;
}

void GroundClaims::finish(const Settle& settle) {
  for (const auto& [id, aircraft] : aircraft_) {
    if (aircraft.claims > 0) settle(id, run_of(aircraft));
  }
  aircraft_.clear();
}

}  // namespace beespace::io
