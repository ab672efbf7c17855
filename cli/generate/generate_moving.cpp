#include "cli/generate/generate_moving.hpp"

#include "cli/generate/generate_values.hpp"
#include "io/bytes/number_text.hpp"
#include "scenes/moving_scenes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace beespace::cli {
namespace {

// So small that bees meet within a minute.
constexpr double kMovingSide_m = 1'000.0;
// The horizon of predict.
constexpr double kDefaultWithin_s = 60.0;
// How far the pairs of known encounters keep from each other, beyond what they miss.
constexpr double kClear_m = 1'000.0;
// Of one bee, which is what is in memory at a time.
constexpr std::uint64_t kMostFixes = 10'000'000;

Result<std::optional<scenes::FixTimes>> fix_times_of(const GenerateRequest& request) {
  if (!request.duration_s) return std::optional<scenes::FixTimes>();
  if (*request.duration_s / request.interval_s > static_cast<double>(kMostFixes)) {
    return generate_error("--duration " + io::exact(*request.duration_s) + " with --interval " +
                          io::exact(request.interval_s) + " is more than " +
                          io::grouped(kMostFixes) + " fixes a bee; make the interval longer");
  }
  return std::optional(scenes::FixTimes{*request.duration_s, request.interval_s});
}

}  // namespace

bool is_moving_scene(std::string_view scene) {
  constexpr std::array<std::string_view, 5> kScenes = {"flight", "head-on", "crossing",
                                                       "sphere-swap", "encounters"};
  return std::find(kScenes.begin(), kScenes.end(), scene) != kScenes.end();
}

Result<MovingSwarm> make_moving_swarm(const GenerateRequest& request) {
  const auto recorded = fix_times_of(request);
  if (!recorded) return recorded.error();
  const Point size = request.size.value_or(Point{kMovingSide_m, kMovingSide_m, kMovingSide_m});
  const scenes::Speeds& speeds = request.speeds;
  const std::string& scene = request.scene;
  const std::size_t count = request.points;
  const std::uint64_t seed = request.seed;
  MovingSwarm swarm{{}, *recorded, seed};
  if (scene == "flight") {
    swarm.movers = scenes::random_flight(count, size, speeds, seed);
  } else if (scene == "crossing") {
    swarm.movers = scenes::crossing_streams(count, size, speeds, seed);
  } else if (scene == "sphere-swap") {
    if (size.x != size.y || size.x != size.z) {
      return generate_error("--scene sphere-swap lives on a sphere; give --size its diameter");
    }
    swarm.movers = scenes::sphere_swap(count, 0.5 * size.x, speeds, seed);
  } else {
    if (count % 2 != 0) {
      return generate_error("--scene " + scene + " makes pairs; give --points an even number");
    }
    const double miss_m = request.miss_m;
    // When they are closest.
    const double within_s = request.duration_s.value_or(kDefaultWithin_s);
    auto pairs = scene == "head-on"
                     ? scenes::head_on_pairs(count / 2, size, speeds, miss_m, within_s, seed)
                     : scenes::known_encounters(
                           count / 2, {speeds, miss_m, within_s, kClear_m + miss_m}, seed);
    swarm.movers = std::move(pairs.movers);
  }
  return swarm;
}

Status check_moving_format(SwarmFormat format, const std::string& scene) {
  using Kind = SwarmFormat::Kind;
  if (format.kind == Kind::kCsv || format.kind == Kind::kTsv) return std::monostate{};
  return generate_error("npy and bin hold positions without velocities; write --scene " + scene +
                        " as csv or tsv");
}

Status write_moving_swarm(const MovingSwarm& swarm, SwarmFormat format, io::AtomicOutput& output) {
  if (!swarm.recorded) return write_movers(swarm.movers, format, output);
  return write_flights(swarm.movers, *swarm.recorded, swarm.seed, format, output);
}

}  // namespace beespace::cli
