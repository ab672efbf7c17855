#include "tests/closed_loop/true_bee.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace beespace::closed_loop {

TrueBee::TrueBee(std::string id, const Start& start, const FlightPlan& plan, std::uint64_t seed)
    : id_(std::move(id)), plan_(plan), random_(seed) {
  stretch_ = {start.position, start.velocity, {}, 0};
  phase_s_ = plan.phase_s + (plan.own_phases ? random_.between(0, 1 / plan.reports_per_s) : 0);
}

bool TrueBee::lasts(int& until, int step, double probability, std::size_t most) {
  if (step > until && random_.happens(probability)) {
    until = step + static_cast<int>(random_.below(most));
    return true;
  }
  return step <= until;
}

void TrueBee::fly(int step, bool has_look, const std::optional<Vector>& advised) {
  const Vector position = this->position();
  const Vector velocity = this->velocity();
  Vector aim = !has_look ? Vector{} : advised.value_or(velocity);
  double acceleration = plan_.max_acceleration_mps2;
  const Faults& faults = plan_.faults;
  if (random_.happens(faults.missed)) {
    if (advised || !has_look) otherwise_ = step;
    aim = velocity;
  }
  const bool willed = step <= own_will_until_;
  if (lasts(own_will_until_, step, faults.own_will)) {
    if (!willed) {
      const double most = plan_.max_speed_mps / 2;
      for (long double& v : own_aim_) v = random_.between(-most, most);
    }
    aim = own_aim_;
    otherwise_ = step;
  }
  if (lasts(weak_until_, step, faults.weak)) {
    acceleration /= 2;
    if (length(aim - velocity) > acceleration * plan_.step_s) otherwise_ = step;
  }
  stretch_ = std::isinf(acceleration)
                 ? Stretch{position, aim, {}, plan_.step_s}
                 : towards(position, velocity, aim, plan_.step_s, acceleration);
}

std::string TrueBee::line(double made_s, long double passed_s) {
  const auto off = [this](double most) { return random_.between(-most, most) / std::sqrt(3.0); };
  Vector position = stretch_.position_at(passed_s);
  Vector velocity = stretch_.velocity_at(passed_s);
  for (long double& x : position) x += off(plan_.faults.position_m);
  for (long double& v : velocity) v += off(plan_.faults.velocity_mps);
  char text[400];
  std::snprintf(text, sizeof text, "%s,%.6f,%.17Lg,%.17Lg,%.17Lg", id_.c_str(),
                plan_.epoch_s + made_s, position[0], position[1], position[2]);
  std::string out = text;
  if (plan_.velocities) {
    std::snprintf(text, sizeof text, ",%.17Lg,%.17Lg,%.17Lg", velocity[0], velocity[1],
                  velocity[2]);
    out += text;
  }
  return out + "\n";
}

std::vector<TrueBee::Line> TrueBee::reports(int step) {
  std::vector<Line> lines;
  const Faults& faults = plan_.faults;
  const double begins_s = step * plan_.step_s;
  const double ends_s = (step + 1) * plan_.step_s;
  const bool silent = lasts(silent_until_, step, faults.silent, random_.happens(0.3) ? 80 : 8);
  for (;; ++next_report_) {
    double due_s = phase_s_ + next_report_ / plan_.reports_per_s;
    if (due_s >= ends_s - 1e-9) break;
    // By the bee's clock, in microseconds; and not so late that it counts for the next step.
    due_s = std::clamp(due_s + random_.between(-faults.jitter_s, faults.jitter_s), begins_s,
                       ends_s - 0.02 * plan_.step_s);
    due_s = std::nearbyint(due_s * 1e6) / 1e6;
    const long double passed_s = std::max(0.0, due_s - begins_s);
    const std::string text = line(due_s, passed_s);
    if (silent || random_.happens(faults.lost)) continue;
    double sent_s = due_s;
    if (random_.happens(faults.late)) sent_s += random_.between(0, 5 * plan_.step_s);
    lines.push_back({sent_s, due_s, text});
    if (random_.happens(faults.repeated)) lines.push_back({sent_s, due_s, text});
  }
  return lines;
}

}  // namespace beespace::closed_loop
