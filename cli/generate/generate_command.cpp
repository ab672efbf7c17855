#include "cli/generate/generate_command.hpp"

#include "cli/generate/generate_moving.hpp"
#include "cli/generate/generate_values.hpp"
#include "io/bytes/atomic_output.hpp"
#include "scenes/swarm_scenes.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr double kDefaultSide_m = 12'800.0;

struct Swarm {
  std::vector<Point> points;
  SwarmUnits units = SwarmUnits::kMetres;
};

Result<Swarm> make_swarm(const GenerateRequest& request) {
  const std::size_t count = request.points;
  if (request.scene == "area") {
    const auto area = scenes::find_area(request.area);
    if (!area) return generate_error("there is no area '" + request.area + "'; known: medellin");
    return Swarm{scenes::geographic_area(count, *area, request.seed), SwarmUnits::kDegrees};
  }
  const Point size = request.size.value_or(Point{kDefaultSide_m, kDefaultSide_m, kDefaultSide_m});
  if (request.scene != "clusters") {
    return Swarm{scenes::uniform_box(count, size, request.seed), SwarmUnits::kMetres};
  }
  if (size.x != size.y || size.x != size.z) {
    return generate_error("--scene clusters lives in a cube; give --size one length");
  }
  return Swarm{scenes::gaussian_clusters(count, static_cast<std::uint32_t>(request.clusters),
                                         request.sigma_m, size.x, request.seed),
               SwarmUnits::kMetres};
}

// Opens the output, and lets `write` fill and commit it.
template <class Write>
Result<ExitCode> write_to(const GenerateRequest& request, const Write& write) {
  auto output = io::AtomicOutput::open(request.output, request.swarm_format.packing());
  if (!output) return std::move(output).error();
  const Status written = write(*output);
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  return ExitCode::kFine;
}

}  // namespace

Result<ExitCode> run_generate(const GenerateRequest& request) {
  const SwarmFormat format = request.swarm_format;
  if (is_moving_scene(request.scene)) {
    if (const Status fit = check_moving_format(format, request.scene); !fit) return fit.error();
    const auto swarm = make_moving_swarm(request);
    if (!swarm) return swarm.error();
    return write_to(request, [&](io::AtomicOutput& output) {
      return write_moving_swarm(*swarm, format, output);
    });
  }
  const auto swarm = make_swarm(request);
  if (!swarm) return swarm.error();
  return write_to(request, [&](io::AtomicOutput& output) {
    return write_swarm(swarm->points, swarm->units, format, output);
  });
}

}  // namespace beespace::cli
