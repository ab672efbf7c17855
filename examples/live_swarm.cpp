// Live: reports in as they come, events out. What is not heard of is stale, not gone.
#include <beespace/beespace.hpp>

#include <cinttypes>
#include <cstdio>

namespace {

const char* name_of(beespace::EventKind kind) {
  switch (kind) {
    case beespace::EventKind::kPredicted:
      return "predicted";
    case beespace::EventKind::kEntered:
      return "entered";
    case beespace::EventKind::kClosestPassed:
      return "closest passed";
    case beespace::EventKind::kLeft:
      return "left";
    case beespace::EventKind::kStale:
      return "stale";
    default:
      return "another event";
  }
}

}  // namespace

int main() {
  beespace::SwarmOptions options;
  options.threshold_m = 5.0;
  options.horizon_s = 4.0;
  options.max_age_s = 2.0;
  beespace::Swarm swarm(options);

  // Two drones on crossing courses, one report a second; the second falls silent after 12 s.
  for (int second = 0; second <= 16; ++second) {
    const double time_s = second;
    bool taken = swarm.update({1, time_s, {-20.0 + 3.0 * time_s, 0.0, 30.0}}).has_value();
    if (second <= 12) {
      taken = swarm.update({2, time_s, {0.0, 22.0 - 3.0 * time_s, 30.0}}).has_value() && taken;
    }
    const auto events = swarm.advance(time_s);
    if (!taken || !events) return 1;
    for (const beespace::SwarmEvent& event : *events) {
      std::printf("at %4.1f s: %s at %.2f s, %" PRIu64 " and %" PRIu64 ", %.2f m\n", time_s,
                  name_of(event.kind), event.time_s, event.first, event.second, event.distance_m);
    }
  }
}
