// A live swarm for minutes: does it keep up with its reports, and does its memory stay flat?
//
//   swarm_soak [BEES] [SECONDS] [HORIZON]
//
// Bees bounce about in a box of 2e-5 bees a cubic metre at 2 to 20 m/s; each reports ten times a
// second, at times of its own, and the swarm is advanced ten times a second. Prints how long
// advance() takes (median, 99th percentile) and the memory in use, for each part of the time.
#include <beespace/swarm.hpp>

#include "scenes/moving_scenes.hpp"
#include "scenes/random_stream.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using beespace::Mover;
using beespace::PointId;

constexpr double kStep_s = 0.1;

class Box {
 public:
  Box(std::size_t bees, double side_m)
      : side_m_(side_m),
        movers_(beespace::scenes::random_flight(bees, {side_m, side_m, side_m}, {2.0, 20.0}, 1)) {
    beespace::scenes::RandomStream random(2);
    for (std::size_t i = 0; i < bees; ++i) phases_s_.push_back(random.uniform(0.0, kStep_s));
  }

  void fly_on() {
    for (Mover& mover : movers_) {
      move(mover.position.x, mover.velocity.x);
      move(mover.position.y, mover.velocity.y);
      move(mover.position.z, mover.velocity.z);
    }
  }

  // The reports of all bees for the step that begins at `time_s`.
  void report_to(beespace::Swarm& swarm, double time_s) const {
    for (PointId id = 0; id < movers_.size(); ++id) {
      const auto& [position, velocity] = movers_[id];
      if (!swarm.update({id, time_s + phases_s_[id], position, velocity})) std::abort();
    }
  }

 private:
  void move(double& place, double& speed) const {
    place += speed * kStep_s;
    if (place < 0.0 || place > side_m_) speed = -speed;
  }

  double side_m_;
  std::vector<Mover> movers_;
  std::vector<double> phases_s_;
};

long resident_mb() {
  long total = 0;
  long resident = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr || std::fscanf(file, "%ld %ld", &total, &resident) != 2) resident = 0;
  if (file != nullptr) std::fclose(file);
  return resident * 4 / 1024;
}

void print_part(double time_s, std::vector<double>& seconds,
                const std::array<long, beespace::kEventKinds>& events) {
  std::sort(seconds.begin(), seconds.end());
  const auto of = [&](beespace::EventKind kind) { return events[static_cast<std::size_t>(kind)]; };
  std::printf(
      "%6.0f s  advance median %6.1f ms, p99 %6.1f ms  memory %ld MB  predicted %ld, entered "
      "%ld, left %ld\n",
      time_s, seconds[seconds.size() / 2] * 1e3, seconds[seconds.size() * 99 / 100] * 1e3,
      resident_mb(), of(beespace::EventKind::kPredicted), of(beespace::EventKind::kEntered),
      of(beespace::EventKind::kLeft));
  std::fflush(stdout);
  seconds.clear();
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int place, double otherwise) {
    return argc > place ? std::atof(argv[place]) : otherwise;
  };
  const auto bees = static_cast<std::size_t>(number(1, 100'000));
  const double lasts_s = number(2, 600);
  const double horizon_s = number(3, 10);
  Box box(bees, std::cbrt(static_cast<double>(bees) / 2e-5));
  beespace::Swarm swarm({.threshold_m = 5.0, .horizon_s = horizon_s});
  std::vector<double> seconds;
  std::array<long, beespace::kEventKinds> events{};
  const auto steps = static_cast<long>(lasts_s / kStep_s);
  const long part = std::max(1L, steps / 20);
  for (long step = 0; step < steps; ++step) {
    const double time_s = static_cast<double>(step) * kStep_s;
    if (step > 0) box.fly_on();
    box.report_to(swarm, time_s);
    const auto begin = std::chrono::steady_clock::now();
    const auto told = swarm.advance(time_s + kStep_s);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (!told) std::abort();
    seconds.push_back(took.count());
    for (const auto& event : *told) ++events[static_cast<std::size_t>(event.kind)];
    if ((step + 1) % part == 0) print_part(time_s + kStep_s, seconds, events);
  }
}
