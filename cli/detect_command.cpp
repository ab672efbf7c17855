#include "cli/detect_command.hpp"

#include "cli/answer_output.hpp"
#include "cli/number_text.hpp"
#include "cli/progress_bar.hpp"
#include "cli/stopwatch.hpp"
#include "cli/summary.hpp"
#include "cli/terminal.hpp"
#include "io/atomic_output.hpp"

#include <beespace/at_risk.hpp>
#include <beespace/nearest.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr std::string_view kHint = " (see 'beespace detect --help')";

Error usage_error(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message) + std::string(kHint), {}};
}

Result<double> read_threshold(const std::string& text) {
  const auto value = parse_number(text);
  if (!value) {
    return Error{
        ErrorCode::kInvalidThreshold,
        "the threshold '" + text + "' is not a number; give metres, for example --threshold 100",
        {}};
  }
  if (*value >= kSmallestCoordinate_m && *value <= kLargestCoordinate_m) return *value;
  return Error{ErrorCode::kInvalidThreshold,
               "the threshold is " + text +
                   " m; give a finite distance above zero (3.9e-121 m to 2.6e+120 m)",
               {}};
}

Result<unsigned> read_threads(const std::string& text) {
  constexpr unsigned kMost = std::numeric_limits<unsigned>::max();
  const auto count = parse_whole(text);
  if (count && *count <= kMost) return static_cast<unsigned>(*count);
  return usage_error("--threads '" + text + "' is not a whole number from 0 (all) to " +
                     grouped(std::uint64_t{kMost}));
}

Answer answer_of(const DetectOptions& options) {
  if (options.csv) return Answer::kCsv;
  if (options.json) return Answer::kJson;
  return options.geojson ? Answer::kGeoJson : Answer::kIds;
}

Result<DetectRequest> check(const DetectOptions& options) {
  DetectRequest request;
  if (options.input.empty() && input_is_terminal()) {
    return usage_error("say which file to read, or pipe the input in");
  }
  if (!options.input.empty()) request.input = options.input;
  if (int{options.csv} + int{options.json} + int{options.geojson} > 1) {
    return usage_error("--csv, --json and --geojson exclude each other");
  }
  request.output = options.output;
  auto threshold = read_threshold(options.threshold);
  if (!threshold) return std::move(threshold).error();
  const auto threads = read_threads(options.threads);
  if (!threads) return threads.error();
  request.search = {*threshold, options.inclusive, *threads};

  if (options.frame == "wgs84") request.load.frame = io::Frame::kWgs84;
  if (options.frame == "metres") request.load.frame = io::Frame::kMetres;
  if (options.format == "text") request.load.format = io::Format::kText;
  if (options.format == "npy") request.load.format = io::Format::kNpy;
  if (options.format == "bin") request.load.format = io::Format::kRawFloat64;
  request.load.columns = options.columns;
  request.load.skip_bad = options.skip_bad;
  request.load.threads = *threads;

  request.answer = answer_of(options);
  request.nearest = options.nearest;
  request.fail_on_risk = options.fail_on_risk;
  request.quiet = options.quiet;
  return request;
}

// The closest pair of all. When somebody is at risk, both of the pair are, so that it is enough to
// look among these; their order is that of all, so that ties are decided alike.
Result<std::optional<ClosestPair>> closest_pair(const std::vector<Point>& points,
                                                const std::vector<PointId>& at_risk,
                                                unsigned threads) {
  if (at_risk.empty() || at_risk.size() > points.size() / 2) {
    return find_closest_pair(points, threads);
  }
  std::vector<Point> some;
  some.reserve(at_risk.size());
  for (const PointId id : at_risk) some.push_back(points[id]);
  auto found = find_closest_pair(some, threads);
  if (!found || !*found) return found;
  const ClosestPair& pair = **found;
  return std::optional<ClosestPair>(
      ClosestPair{at_risk[pair.first], at_risk[pair.second], pair.distance_m});
}

Result<Detection> search(const io::LoadedPoints& loaded, const DetectRequest& request) {
  Detection detection;
  auto at_risk = find_at_risk(loaded.points, request.search);
  if (!at_risk) return std::move(at_risk).error();
  detection.at_risk = std::move(*at_risk);
  if (request.nearest) {
    auto nearest = find_nearest_within(loaded.points, request.search);
    if (!nearest) return std::move(nearest).error();
    detection.nearest = std::move(*nearest);
  }
  if (!request.quiet || request.answer == Answer::kJson) {
    auto closest = closest_pair(loaded.points, detection.at_risk, request.search.threads);
    if (!closest) return std::move(closest).error();
    detection.closest = *closest;
  }
  return detection;
}

// Says when an id is not shown as the file has it; JSON needs no blanks.
void note_ids(const ShownIds& ids, Answer answer, std::vector<std::string>& notes) {
  if (const std::size_t count = ids.empty_count(); count > 0) {
    notes.push_back(grouped(count) + (count == 1 ? " bee at risk has" : " bees at risk have") +
                    " an empty id: the data row stands for it");
  }
  if (const std::size_t count = ids.broken_count(); count > 0 && answer == Answer::kIds) {
    notes.push_back("tabs and line ends inside an id are written as blanks (" + grouped(count) +
                    (count == 1 ? " id)" : " ids)"));
  }
}

void write_answer(const io::LoadedPoints& loaded, const Detection& detection, const ShownIds& ids,
                  const DetectRequest& request, io::AtomicOutput& output) {
  switch (request.answer) {
    case Answer::kIds:
      return write_ids(detection, ids, request.nearest, output);
    case Answer::kCsv:
      return write_csv(loaded, detection, request.nearest, output);
    case Answer::kJson:
      return write_json(loaded, detection, ids, request, output);
    case Answer::kGeoJson:
      return write_geojson(loaded, detection, ids, request.nearest, output);
  }
}

// Says what went wrong; with --json also where a program looks for it.
ExitCode fail(const Error& error, bool json) {
  say_error(printable(to_string(error)));
  if (json) {
    auto output = io::AtomicOutput::open("-");
    if (output) {
      output->write(error_as_json(error));
      // That nobody reads it is not worse than what went wrong already.
      static_cast<void>(output->commit());
    }
  }
  return exit_code_for(error.code);
}

Result<io::LoadedPoints> load(const DetectRequest& request, ProgressBar& progress) {
  io::LoadOptions options = request.load;
  options.progress = &progress.reading();
  auto loaded = io::load_points(request.input, options);
  if (loaded && request.answer == Answer::kGeoJson && loaded->frame != io::Frame::kWgs84) {
    return usage_error(
        "--geojson needs longitude and latitude, but the input was taken for metres: " +
        loaded->frame_reason);
  }
  return loaded;
}

// The whole run; the exit code, or what went wrong.
Result<ExitCode> detect(const DetectRequest& request) {
  // Opened first, so that a folder that is not there is known before a long read.
  auto output = io::AtomicOutput::open(request.output);
  if (!output) return std::move(output).error();
  ProgressBar progress(!request.quiet);
  Stopwatch watch;
  auto loaded = load(request, progress);
  if (!loaded) return std::move(loaded).error();
  const double read_s = watch.lap();

  progress.enter_stage("searching");
  auto detection = search(*loaded, request);
  if (!detection) return std::move(detection).error();
  detection->timings.read_s = read_s;
  detection->timings.search_s = watch.lap();

  progress.enter_stage("writing");
  // Records that are written as they stand need no ids.
  const std::vector<PointId> none;
  const ShownIds ids(*loaded, request.answer == Answer::kCsv ? none : detection->at_risk);
  note_ids(ids, request.answer, loaded->notes);
  write_answer(*loaded, *detection, ids, request, *output);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  detection->timings.write_s = watch.lap();

  progress.finish();
  if (!request.quiet) say(summary(*loaded, *detection, request));
  const bool risk = request.fail_on_risk && !detection->at_risk.empty();
  return risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace

ExitCode run_detect(const DetectOptions& options) {
  const auto request = check(options);
  if (!request) return fail(request.error(), options.json);
  const auto code = detect(*request);
  return code ? *code : fail(code.error(), options.json);
}

}  // namespace beespace::cli
