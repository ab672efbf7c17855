#include "cli/generate_command.hpp"

#include "cli/number_text.hpp"
#include "cli/option_values.hpp"
#include "cli/swarm_output.hpp"
#include "cli/terminal.hpp"
#include "io/atomic_output.hpp"
#include "scenes/swarm_scenes.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr double kDefaultSide_m = 12'800.0;
constexpr std::uint64_t kDefaultClusters = 100;
constexpr double kDefaultSigma_m = 200.0;
// Within these every coordinate is surely one that a search takes.
constexpr double kSmallestSize_m = 1e-6;
constexpr double kLargestSize_m = 1e15;
constexpr const char* kSizes = " (0.000001 to 1e15)";

struct Swarm {
  std::vector<Point> points;
  SwarmUnits units = SwarmUnits::kMetres;
};

Error usage_error(std::string message) {
  return cli::usage_error("generate", std::move(message));
}

// A whole number from 1 to `most`.
Result<std::uint64_t> read_count(const std::string& text, const std::string& option,
                                 std::uint64_t most) {
  const auto count = parse_whole(text);
  if (count && *count >= 1 && *count <= most) return *count;
  return usage_error(option + " '" + text + "' is not a whole number from 1 to " + grouped(most));
}

std::optional<double> read_length(std::string_view text) {
  const auto value = parse_number(text);
  const bool good = value && *value >= kSmallestSize_m && *value <= kLargestSize_m;
  return good ? value : std::nullopt;
}

// "12800" or "3300x2300x480".
Result<Point> read_size(const std::string& text) {
  const Error error = usage_error("--size '" + text + "' is not a length in metres" + kSizes +
                                  ", nor three as in 3300x2300x480");
  std::vector<double> sides;
  std::string_view rest = text;
  while (true) {
    const std::size_t end = std::min(rest.find('x'), rest.size());
    const auto side = read_length(rest.substr(0, end));
    if (!side) return error;
    sides.push_back(*side);
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  if (sides.size() == 1) return Point{sides[0], sides[0], sides[0]};
  if (sides.size() != 3) return error;
  return Point{sides[0], sides[1], sides[2]};
}

std::string scene_of(const GenerateOptions& options) {
  if (!options.scene.empty()) return options.scene;
  if (!options.area.empty()) return "area";
  return options.clusters.empty() && options.sigma.empty() ? "uniform" : "clusters";
}

// An option that the scene would ignore is a misunderstanding.
std::optional<Error> check_fit(const GenerateOptions& options, const std::string& scene) {
  const auto misfit = [&scene](const char* option) {
    return usage_error(std::string(option) + " does not apply to --scene " + scene);
  };
  if (scene != "area" && !options.area.empty()) return misfit("--area");
  if (scene == "area" && !options.size.empty()) return misfit("--size");
  if (scene != "clusters" && !options.clusters.empty()) return misfit("--clusters");
  if (scene != "clusters" && !options.sigma.empty()) return misfit("--sigma");
  return std::nullopt;
}

Result<Swarm> make_clusters(const GenerateOptions& options, std::size_t count, const Point& size,
                            std::uint64_t seed) {
  if (size.x != size.y || size.x != size.z) {
    return usage_error("--scene clusters lives in a cube; give --size one length");
  }
  std::uint64_t clusters = kDefaultClusters;
  if (!options.clusters.empty()) {
    const auto given = read_count(options.clusters, "--clusters", kMaxPoints);
    if (!given) return given.error();
    clusters = *given;
  }
  std::optional<double> sigma = kDefaultSigma_m;
  if (!options.sigma.empty()) sigma = read_length(options.sigma);
  if (!sigma) {
    return usage_error("--sigma '" + options.sigma + "' is not a length in metres" + kSizes);
  }
  return Swarm{
      scenes::gaussian_clusters(count, static_cast<std::uint32_t>(clusters), *sigma, size.x, seed),
      SwarmUnits::kMetres};
}

Result<Swarm> make_swarm(const GenerateOptions& options) {
  const auto count = read_count(options.points, "--points", kMaxPoints);
  if (!count) return count.error();
  const auto seed = parse_whole(options.seed);
  if (!seed) {
    return usage_error("--seed '" + options.seed + "' is not a whole number from 0 to " +
                       std::to_string(std::numeric_limits<std::uint64_t>::max()));
  }
  const std::string scene = scene_of(options);
  if (const auto misfit = check_fit(options, scene)) return *misfit;
  if (scene == "area") {
    const auto area = scenes::find_area(options.area.empty() ? "medellin" : options.area);
    if (!area) {
      return usage_error("there is no area '" + options.area + "'; known: medellin");
    }
    return Swarm{scenes::geographic_area(*count, *area, *seed), SwarmUnits::kDegrees};
  }
  Point size{kDefaultSide_m, kDefaultSide_m, kDefaultSide_m};
  if (!options.size.empty()) {
    const auto given = read_size(options.size);
    if (!given) return given.error();
    size = *given;
  }
  if (scene == "clusters") return make_clusters(options, *count, size, *seed);
  return Swarm{scenes::uniform_box(*count, size, *seed), SwarmUnits::kMetres};
}

Result<SwarmFormat> format_of(const GenerateOptions& options) {
  const bool named = options.output != "-";
  if (!options.format.empty()) {
    const SwarmFormat format = *swarm_format(options.format);
    if (!named || ending_allows(options.output, format)) return format;
    return usage_error("--format " + options.format + " contradicts the ending of '" +
                       options.output + "'; correct one of them");
  }
  if (!named) return SwarmFormat{};
  if (const auto format = swarm_format(options.output)) return *format;
  return usage_error("the ending of '" + options.output +
                     "' does not tell the format; add --format csv, tsv, npy or bin");
}

Result<ExitCode> generate(const GenerateOptions& options) {
  const auto format = format_of(options);
  if (!format) return format.error();
  const auto swarm = make_swarm(options);
  if (!swarm) return swarm.error();
  auto output = io::AtomicOutput::open(options.output);
  if (!output) return std::move(output).error();
  const Status written = write_swarm(swarm->points, swarm->units, *format, *output);
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  return ExitCode::kFine;
}

}  // namespace

ExitCode run_generate(const GenerateOptions& options) {
  const auto code = generate(options);
  if (code) return *code;
  say_error(printable(to_string(code.error())));
  return exit_code_for(code.error().code);
}

}  // namespace beespace::cli
