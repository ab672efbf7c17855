#include "sim/true_agent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::sim {

namespace {

bool moves(const Setpoint& setpoint) {
  return setpoint.nominal.velocity != Velocity{} || setpoint.correction != Velocity{};
}

}  // namespace

TrueAgent::TrueAgent(const Follower& follower, const Point& start, const AgentLoop& loop,
                     const AgentErrors& errors, std::uint64_t seed)
    : follower_(follower),
      start_(start),
      loop_(loop),
      errors_(errors),
      clock_(errors.clock, loop.instant_ns, seed * 2 + 1),
      disturbance_(errors.disturbance, seed * 2 + 2),
      position_(vector_of(start)) {
  measured_.assign(static_cast<std::size_t>(loop.delay) + 1, position_);
  stretch_.position = position_;
}

bool TrueAgent::look_at_clock() {
  const Tick before = follower_.tick();
  follower_.advance(loop_.floors_ticks
                        ? static_cast<Tick>(summed_s_ / (static_cast<double>(tick_ns()) * 1e-9))
                        : floor_divided(clock_.shows_ns(), tick_ns()));
  return !std::exchange(began_, true) || follower_.tick() > before;
}

// A clock that is behind its own tick shows that tick's begin: ticks never run backwards.
Setpoint TrueAgent::setpoint_at(std::int64_t clock_ns) const {
  if (follower_.held() == 0) return {{start_, {}}, {}, true};
  std::int64_t after_ns = std::max<std::int64_t>(0, clock_ns - follower_.tick() * tick_ns());
  if (loop_.floors_ticks) after_ns = clock_ns - floor_divided(clock_ns, tick_ns()) * tick_ns();
  return follower_.setpoint(static_cast<double>(after_ns) * 1e-9);
}

Setpoint TrueAgent::setpoint() const {
  return setpoint_at(clock_.shows_ns());
}

double TrueAgent::deviation_m() const {
  return length_of(position_ - vector_of(setpoint().nominal.position));
}

AgentReport TrueAgent::report() {
  AgentReport report;
  report.held = follower_.held();
  report.tick = follower_.tick();
  const std::int64_t after_ns = clock_.shows_ns() - follower_.tick() * tick_ns();
  report.after_s = static_cast<double>(std::max<std::int64_t>(0, after_ns)) * 1e-9;
  report.position = point_of(position_ + disturbance_.error(errors_.report_error_m));
  report.velocity = velocity_of(velocity() + disturbance_.error(errors_.report_velocity_error_mps));
  return report;
}

Vector3 TrueAgent::velocity() const {
  return flies_ ? own_velocity_ + disturbance_.velocity() : Vector3{};
}

void TrueAgent::measure() {
  std::rotate(measured_.begin(), measured_.begin() + 1, measured_.end());
  measured_.back() = position_ + disturbance_.error(errors_.sensing_error_m) - own_way_;
}

// Two real poles, both exp(-gain T), for the sampled loop of a deviation and its speed.
void TrueAgent::correct(const Setpoint& now) {
  const double period_s = static_cast<double>(loop_.period) * instant_s();
  const double pole = std::exp(-loop_.gain_per_s * period_s);
  const double of_place = (1.0 - pole) * (1.0 - pole) / (period_s * period_s);
  const double of_speed = (2.0 - 2.0 * pole - (1.0 - pole) * (1.0 - pole) / 2.0) / period_s;
  const Vector3 off = measured_.front() + own_way_ - vector_of(now.nominal.position);
  const Vector3 speed = own_velocity_ - vector_of(now.nominal.velocity);
  correction_mps2_ = (off * of_place + speed * of_speed) * -1.0;
}

void TrueAgent::fly(const Vector3& towards) {
  const Setpoint now = setpoint();
  const Setpoint next = setpoint_at(clock_.will_show_ns());
  const bool on_board = loop_.place == LoopPlace::kOnboard;
  flies_ = flies_ || on_board || moves(now) || moves(next);
  if (flies_) fly_by(now, next, towards);
  if (!flies_) stretch_ = {position_, {}, {}};
  clock_.go_on();
  ++instant_;
  summed_s_ += instant_s();
}

void TrueAgent::fly_by(const Setpoint& now, const Setpoint& next, const Vector3& towards) {
  const double lasts_s = instant_s();
  const bool on_board = loop_.place == LoopPlace::kOnboard;
  if (on_board) measure();
  if (on_board && instant_ % static_cast<std::uint64_t>(loop_.period) == 0) correct(now);
  // The change of the nominal velocity, and the correction; or the velocity as it is told.
  const Vector3 change =
      on_board ? vector_of(next.nominal.velocity) - vector_of(now.nominal.velocity) +
                     correction_mps2_ * lasts_s
               : vector_of(next.nominal.velocity) + vector_of(next.correction) - own_velocity_;
  const double most_mps = errors_.strength * loop_.max_acceleration_mps2 * lasts_s;
  const Vector3 flown = shortened(change, most_mps);

  const Vector3 carried = disturbance_.velocity();
  disturbance_.go_on(lasts_s, towards);
  stretch_.position = position_;
  stretch_.velocity = own_velocity_ + carried;
  stretch_.acceleration = (flown + disturbance_.velocity() - carried) * (1.0 / lasts_s);
  position_ += stretch_.velocity * lasts_s + stretch_.acceleration * (0.5 * lasts_s * lasts_s);
  own_way_ += own_velocity_ * lasts_s + flown * (0.5 * lasts_s);
  own_velocity_ += flown;
}

}  // namespace beespace::sim
