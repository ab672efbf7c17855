#include "cli/generate/generate_command.hpp"

#include "cli/console/terminal.hpp"
#include "cli/generate/generate_moving.hpp"
#include "cli/generate/generate_values.hpp"
#include "cli/output/swarm_output.hpp"
#include "io/bytes/atomic_output.hpp"
#include "scenes/swarm_scenes.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr double kDefaultSide_m = 12'800.0;
constexpr std::uint64_t kDefaultClusters = 100;
constexpr double kDefaultSigma_m = 200.0;

struct Swarm {
  std::vector<Point> points;
  SwarmUnits units = SwarmUnits::kMetres;
};

std::string scene_of(const GenerateOptions& options) {
  if (!options.scene.empty()) return options.scene;
  if (!options.area.empty()) return "area";
  if (!options.clusters.empty() || !options.sigma.empty()) return "clusters";
  const bool flies =
      !options.speed.empty() || !options.duration.empty() || !options.interval.empty();
  return flies ? "flight" : "uniform";
}

// An option that the scene would ignore is a misunderstanding.
Status check_fit(const GenerateOptions& options, const std::string& scene) {
  const bool moving = is_moving_scene(scene);
  const bool pairs = scene == "head-on" || scene == "encounters";
  const struct {
    const char* name;
    const std::string& given;
    bool fits;
  } table[] = {
      {"--size", options.size, scene != "area" && scene != "encounters"},
      {"--clusters", options.clusters, scene == "clusters"},
      {"--sigma", options.sigma, scene == "clusters"},
      {"--area", options.area, scene == "area"},
      {"--speed", options.speed, moving},
      {"--miss", options.miss, pairs},
      {"--duration", options.duration, moving},
      {"--interval", options.interval, moving},
  };
  for (const auto& option : table) {
    if (option.fits || option.given.empty()) continue;
    return generate_error(std::string(option.name) + " does not apply to --scene " + scene);
  }
  return std::monostate{};
}

Result<Swarm> make_clusters(const GenerateOptions& options, std::size_t count, const Point& size,
                            std::uint64_t seed) {
  if (size.x != size.y || size.x != size.z) {
    return generate_error("--scene clusters lives in a cube; give --size one length");
  }
  std::uint64_t clusters = kDefaultClusters;
  if (!options.clusters.empty()) {
    const auto given = read_count(options.clusters, "--clusters", kMaxPoints);
    if (!given) return given.error();
    clusters = *given;
  }
  double sigma_m = kDefaultSigma_m;
  if (!options.sigma.empty()) {
    const auto given = read_length(options.sigma, "--sigma");
    if (!given) return given.error();
    sigma_m = *given;
  }
  return Swarm{
      scenes::gaussian_clusters(count, static_cast<std::uint32_t>(clusters), sigma_m, size.x, seed),
      SwarmUnits::kMetres};
}

Result<Swarm> make_swarm(const GenerateOptions& options, const std::string& scene,
                         std::size_t count, std::uint64_t seed) {
  if (scene == "area") {
    const auto area = scenes::find_area(options.area.empty() ? "medellin" : options.area);
    if (!area) {
      return generate_error("there is no area '" + options.area + "'; known: medellin");
    }
    return Swarm{scenes::geographic_area(count, *area, seed), SwarmUnits::kDegrees};
  }
  const auto size = read_size(options.size, kDefaultSide_m);
  if (!size) return size.error();
  if (scene == "clusters") return make_clusters(options, count, *size, seed);
  return Swarm{scenes::uniform_box(count, *size, seed), SwarmUnits::kMetres};
}

Result<SwarmFormat> format_of(const GenerateOptions& options) {
  const bool named = options.output != "-";
  if (!options.format.empty()) {
    const SwarmFormat format = *swarm_format("." + options.format);
    if (!named || ending_allows(options.output, format)) return format;
    return generate_error("--format " + options.format + " contradicts the ending of '" +
                          options.output + "'; correct one of them");
  }
  if (!named) return SwarmFormat{};
  if (const auto format = swarm_format(options.output)) return *format;
  return generate_error("the ending of '" + options.output +
                        "' does not tell the format; add --format csv, tsv, npy or bin");
}

// Opens the output, and lets `write` fill and commit it.
template <class Write>
Result<ExitCode> write_to(const std::string& name, SwarmFormat format, const Write& write) {
  auto output = io::AtomicOutput::open(name, format.packing());
  if (!output) return std::move(output).error();
  const Status written = write(*output);
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  return ExitCode::kFine;
}

Result<ExitCode> generate(const GenerateOptions& options) {
  const auto format = format_of(options);
  if (!format) return format.error();
  const auto count = read_count(options.points, "--points", kMaxPoints);
  if (!count) return count.error();
  const auto seed = read_seed(options.seed);
  if (!seed) return seed.error();
  const std::string scene = scene_of(options);
  if (const Status fit = check_fit(options, scene); !fit) return fit.error();
  if (is_moving_scene(scene)) {
    if (const Status fit = check_moving_format(*format, scene); !fit) return fit.error();
    const auto swarm = make_moving_swarm(options, scene, *count, *seed);
    if (!swarm) return swarm.error();
    return write_to(options.output, *format, [&](io::AtomicOutput& output) {
      return write_moving_swarm(*swarm, *format, output);
    });
  }
  const auto swarm = make_swarm(options, scene, *count, *seed);
  if (!swarm) return swarm.error();
  return write_to(options.output, *format, [&](io::AtomicOutput& output) {
    return write_swarm(swarm->points, swarm->units, *format, output);
  });
}

}  // namespace

ExitCode run_generate(const GenerateOptions& options) {
  const auto code = generate(options);
  if (code) return *code;
  say_error(printable(to_string(code.error())));
  return exit_code_for(code.error().code);
}

}  // namespace beespace::cli
