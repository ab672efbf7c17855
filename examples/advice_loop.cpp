// Advice in a loop: eight drones on a circle fly to the opposite point, through the middle of all.
// A Verifier, which knows nothing of the advice, checks what was flown, between the steps too.
#include <beespace/beespace.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <span>
#include <vector>

int main() {
  constexpr std::size_t kDrones = 8;
  const beespace::FlightLimits limits{.max_speed_mps = 6.0, .max_acceleration_mps2 = 4.0};
  beespace::AdviseOptions options;
  options.threshold_m = 2.0;
  options.step_s = 0.1;

  std::vector<beespace::Mover> drones(kDrones);
  std::vector<beespace::Point> goals(kDrones);
  for (std::size_t i = 0; i < kDrones; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kDrones;
    drones[i].position = {30.0 * std::cos(angle), 30.0 * std::sin(angle), 40.0};
    goals[i] = {-drones[i].position.x, -drones[i].position.y, 40.0};
  }

  beespace::Verifier verifier({.threshold_m = 2.0,
                               .max_speed_mps = limits.max_speed_mps,
                               .max_acceleration_mps2 = limits.max_acceleration_mps2});
  beespace::Adviser adviser;
  beespace::Advised advised;
  std::vector<beespace::Velocity> preferred(kDrones);
  std::size_t not_certified = 0;

  for (int step = 0; step < 250; ++step) {
    if (!verifier.add(step * options.step_s, drones)) return 1;
    for (std::size_t i = 0; i < kDrones; ++i) {
      const auto velocity = beespace::velocity_to_goal(drones[i].position, goals[i], limits, 0.1);
      if (!velocity) return 1;
      preferred[i] = *velocity;
    }
    const auto status = adviser.advise(drones, preferred, std::span(&limits, 1), options, advised);
    if (!status) {
      std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
      return 1;
    }
    for (std::size_t i = 0; i < kDrones; ++i) {
      if (!advised.advice[i].certified) ++not_certified;
      // The nominal state: where this step leads as advised. The next call begins there.
      const beespace::Velocity advised_velocity = advised.advice[i].velocity;
      beespace::Mover& drone = drones[i];
      drone.position.x += (drone.velocity.x + advised_velocity.x) / 2.0 * options.step_s;
      drone.position.y += (drone.velocity.y + advised_velocity.y) / 2.0 * options.step_s;
      drone.position.z += (drone.velocity.z + advised_velocity.z) / 2.0 * options.step_s;
      drone.velocity = advised_velocity;
    }
  }

  std::size_t arrived = 0;
  for (std::size_t i = 0; i < kDrones; ++i) {
    if (beespace::distance(drones[i].position, goals[i]) < 1.0) ++arrived;
  }
  const beespace::Verdict& verdict = verifier.verdict();
  std::printf("arrived: %zu of %zu, not certified: %zu\n", arrived, kDrones, not_certified);
  std::printf("verdict: %s, %llu losses of separation in %llu steps\n",
              verdict.holds() ? "holds" : "does not hold",
              static_cast<unsigned long long>(verdict.losses),
              static_cast<unsigned long long>(verdict.steps));
}
