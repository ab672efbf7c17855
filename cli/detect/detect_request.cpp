#include "cli/detect/detect_request.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"

#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kDefaultThreshold = "100";  // the paper's

// An option that the report would ignore is a misunderstanding.
std::optional<Error> check_fit(const DetectOptions& options, const Report& report) {
  const auto misfit = [&report](const char* option) {
    return detect_usage_error(std::string(option) + " does not apply to --report " + report.name);
  };
  if (!options.others.empty() && !report.takes_others) return misfit("--others");
  if (!options.max_results.empty() && !report.has_limit) return misfit("--max-results");
  if (!options.vertical.empty() && !report.takes_vertical) return misfit("--vertical");
  if (options.at_risk_only && !report.lists_everybody) return misfit("--at-risk-only");
  return std::nullopt;
}

std::optional<Error> check_inputs(const DetectOptions& options) {
  if (options.input.empty() && (input_is_terminal() || options.others == "-")) {
    return detect_usage_error("say which file to read, or pipe the input in");
  }
  if (options.input == "-" && options.others == "-") {
    return detect_usage_error("standard input can be read once; name a file for one of the two");
  }
  return std::nullopt;
}

io::LoadOptions load_options(const DetectOptions& options, unsigned threads) {
  io::LoadOptions load;
  if (options.frame == "wgs84") load.frame = io::Frame::kWgs84;
  if (options.frame == "metres") load.frame = io::Frame::kMetres;
  if (options.format == "text") load.format = io::Format::kText;
  if (options.format == "npy") load.format = io::Format::kNpy;
  if (options.format == "bin") load.format = io::Format::kRawFloat64;
  load.format_can_be_said = true;
  if (options.heights == "geometric") load.heights = io::HeightSource::kGeometric;
  if (options.heights == "pressure") load.heights = io::HeightSource::kPressure;
  load.columns = options.columns;
  load.skip_bad = options.skip_bad;
  load.threads = threads;
  return load;
}

}  // namespace

Error detect_usage_error(std::string message) {
  return usage_error("detect", std::move(message));
}

Result<DetectRequest> request_of(const DetectOptions& options) {
  if (auto error = check_inputs(options)) return *std::move(error);
  const auto form =
      output_form("detect", {options.output, options.csv, options.json, options.geojson},
                  {{Form::kText, Form::kCsv, Form::kJson, Form::kGeoJson}});
  if (!form) return form.error();
  DetectRequest request;
  request.report = find_report(options.report);
  if (auto error = check_fit(options, *request.report)) return *std::move(error);
  const auto threshold =
      read_threshold(options.threshold.empty() ? kDefaultThreshold : options.threshold);
  if (!threshold) return threshold.error();
  const auto threads = read_threads("detect", options.threads);
  if (!threads) return threads.error();
  const auto max_results = read_max_results("detect", options.max_results);
  if (!max_results) return max_results.error();
  request.search = {*threshold, options.inclusive, *threads, *max_results};
  const auto vertical = read_vertical("detect", options.vertical);
  if (!vertical) return vertical.error();
  request.default_threshold = options.threshold.empty();
  request.vertical = *vertical;
  if (*vertical) request.search.vertical_m = (*vertical)->metric;
  const auto units = io::read_unit_overrides(options.units);
  if (!units) return detect_usage_error(units.error().message);

  if (!options.input.empty()) request.input = options.input;
  if (!options.others.empty()) request.others = options.others;
  request.output = options.output;
  request.load = load_options(options, *threads);
  request.form = *form;
  request.load.units = *units;
  request.unique_ids = options.unique_ids;
  request.at_risk_only = options.at_risk_only;
  request.fail_on_risk = options.fail_on_risk;
  request.quiet = options.quiet;
  return request;
}

}  // namespace beespace::cli
