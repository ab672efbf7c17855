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
constexpr double kDefaultSide_m = 1'000.0;
constexpr const char* kDefaultSpeeds = "5-20";
constexpr const char* kDefaultMiss = "10";
constexpr const char* kDefaultInterval = "1";
// The horizon of predict.
constexpr double kDefaultWithin_s = 60.0;
// How far the pairs of known encounters keep from each other, beyond what they miss.
constexpr double kClear_m = 1'000.0;
// Of one bee, which is what is in memory at a time.
constexpr std::uint64_t kMostFixes = 10'000'000;

// What the options say of a flight, whatever the scene.
struct FlightWishes {
  Point size;
  scenes::Speeds speeds;
  double miss_m;
  double within_s;  // when pairs are closest
  std::optional<scenes::FixTimes> recorded;
};

std::string or_default(const std::string& given, const char* otherwise) {
  return given.empty() ? otherwise : given;
}

Result<std::optional<scenes::FixTimes>> read_fix_times(const GenerateOptions& options) {
  if (options.duration.empty()) {
    if (options.interval.empty()) return std::optional<scenes::FixTimes>();
    return generate_error("--interval is about recordings; add --duration SECONDS");
  }
  const auto duration = read_seconds(options.duration, "--duration");
  if (!duration) return duration.error();
  const auto interval = read_seconds(or_default(options.interval, kDefaultInterval), "--interval");
  if (!interval) return interval.error();
  if (*duration / *interval > static_cast<double>(kMostFixes)) {
    return generate_error("--duration " + io::exact(*duration) + " with --interval " +
                          io::exact(*interval) + " is more than " + io::grouped(kMostFixes) +
                          " fixes a bee; make the interval longer");
  }
  return std::optional(scenes::FixTimes{*duration, *interval});
}

Result<FlightWishes> read_wishes(const GenerateOptions& options) {
  const auto size = read_size(options.size, kDefaultSide_m);
  if (!size) return size.error();
  const auto speeds = read_speeds(or_default(options.speed, kDefaultSpeeds));
  if (!speeds) return speeds.error();
  const auto miss = read_distance(or_default(options.miss, kDefaultMiss), "--miss");
  if (!miss) return miss.error();
  const auto recorded = read_fix_times(options);
  if (!recorded) return recorded.error();
  const double within_s = *recorded ? (*recorded)->duration_s : kDefaultWithin_s;
  return FlightWishes{*size, *speeds, *miss, within_s, *recorded};
}

}  // namespace

bool is_moving_scene(std::string_view scene) {
  constexpr std::array<std::string_view, 5> kScenes = {"flight", "head-on", "crossing",
                                                       "sphere-swap", "encounters"};
  return std::find(kScenes.begin(), kScenes.end(), scene) != kScenes.end();
}

Result<MovingSwarm> make_moving_swarm(const GenerateOptions& options, const std::string& scene,
                                      std::size_t count, std::uint64_t seed) {
  const auto wishes = read_wishes(options);
  if (!wishes) return wishes.error();
  const Point& size = wishes->size;
  const scenes::Speeds& speeds = wishes->speeds;
  MovingSwarm swarm{{}, wishes->recorded, seed};
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
    const double miss_m = wishes->miss_m;
    const double within_s = wishes->within_s;
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
