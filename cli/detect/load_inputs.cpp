#include "cli/detect/load_inputs.hpp"

#include "cli/analysis/number_text.hpp"
#include "cli/analysis/recording_check.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/detect/detect_request.hpp"
#include "io/load_points.hpp"
#include "io/points/loaded_points.hpp"
#include "io/problems/excerpt.hpp"

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

// Refused where they are to be unique.
Result<io::RepeatedIds> repeated_ids(const io::LoadedPoints& loaded, const std::string& path,
                                     bool unique) {
  io::RepeatedIds repeated = io::find_repeated_ids(loaded);
  if (!unique || repeated.count == 0) return repeated;
  Error error{ErrorCode::kMalformedRecord,
              text_of(repeated) + "; give each bee an id of its own, or leave --unique-ids out",
              {}};
  error.place.source = path == "-" ? "<stdin>" : path;
  error.place.record = repeated.second_row;
  return error;
}

// Never some by pressure and some by satellites.
std::optional<Error> datum_problem(const io::LoadedPoints& ours, const io::LoadedPoints& others) {
  const auto none = io::HeightDatum::kUnstated;
  if (ours.heights == others.heights || ours.heights == none || others.heights == none) {
    return std::nullopt;
  }
  return detect_usage_error("the heights of the two swarms cannot be compared: ours are " +
                            std::string(datum_text(ours.heights)) + ", theirs " +
                            std::string(datum_text(others.heights)) +
                            "; take the same of both with --heights or --columns");
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
  auto our_repeated = repeated_ids(*ours, request.input, request.unique_ids);
  if (!our_repeated) return std::move(our_repeated).error();
  Inputs inputs{*std::move(ours), std::nullopt};
  inputs.our_repeated = *std::move(our_repeated);
  if (!request.others) return inputs;
  auto others = load_snapshot(*request.others, options);
  if (!others) return std::move(others).error();
  if (others->frame != inputs.ours.frame) {
    return detect_usage_error(
        "the two swarms are not in the same frame: " + taken_for(inputs.ours, request.input) +
        ", and " + taken_for(*others, *request.others) +
        "; convert one, or say with --crs what both are");
  }
  if (auto problem = datum_problem(inputs.ours, *others)) return *std::move(problem);
  auto their_repeated = repeated_ids(*others, *request.others, request.unique_ids);
  if (!their_repeated) return std::move(their_repeated).error();
  inputs.their_repeated = *std::move(their_repeated);
  inputs.others = *std::move(others);
  return inputs;
}

}  // namespace beespace::cli
