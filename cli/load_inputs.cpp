#include "cli/load_inputs.hpp"

#include "cli/detect_request.hpp"
#include "cli/recording_check.hpp"

#include <string>
#include <utility>

namespace beespace::cli {
namespace {

std::string source_of(const std::string& path) {
  return path == "-" ? "standard input" : "'" + path + "'";
}

std::string taken_for(const io::LoadedPoints& loaded, const std::string& path) {
  return source_of(path) + " was taken for " +
         (loaded.frame == io::Frame::kWgs84 ? "degrees" : "metres") + " (" + loaded.frame_reason +
         ")";
}

Result<io::LoadedPoints> load_snapshot(const std::string& path, const io::LoadOptions& options) {
  auto loaded = io::load_points(path, options);
  if (!loaded) return or_recording(std::move(loaded).error(), path, options);
  if (auto problem = recording_problem(*loaded, path)) return *std::move(problem);
  return loaded;
}

}  // namespace

Result<Inputs> load_inputs(const DetectRequest& request, ProgressBar& progress) {
  io::LoadOptions options = request.load;
  options.progress = &progress.reading();
  auto ours = load_snapshot(request.input, options);
  if (!ours) return std::move(ours).error();
  if (request.form.form == Form::kGeoJson && ours->frame != io::Frame::kWgs84) {
    return detect_usage_error(
        "--geojson needs longitude and latitude, but the input was taken for metres: " +
        ours->frame_reason);
  }
  Inputs inputs{*std::move(ours), std::nullopt};
  if (!request.others) return inputs;
  auto others = load_snapshot(*request.others, options);
  if (!others) return std::move(others).error();
  if (others->frame != inputs.ours.frame) {
    return detect_usage_error(
        "the two swarms are not in the same frame: " + taken_for(inputs.ours, request.input) +
        ", and " + taken_for(*others, *request.others) +
        "; convert one, or say with --crs what both are");
  }
  inputs.others = *std::move(others);
  return inputs;
}

}  // namespace beespace::cli
