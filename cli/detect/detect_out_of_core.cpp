#include "cli/detect/detect_out_of_core.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/output_file.hpp"
#include "io/bytes/number_text.hpp"
#include "io/stream_points.hpp"
#include "io/table/table_writer.hpp"

#include <beespace/out_of_core.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// A flag for each point.
class Flags {
 public:
  explicit Flags(std::uint64_t size) : words_((size + 63) / 64) {}

  void set(std::span<const LargeId> ids) {
    for (const LargeId id : ids) words_[id / 64] |= std::uint64_t{1} << (id % 64);
    count_ += ids.size();
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }

  // Those that are set, ascending.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t at = 0; at < words_.size(); ++at) {
      for (std::uint64_t word = words_[at]; word != 0; word &= word - 1) {
        visit(at * 64 + static_cast<std::uint64_t>(std::countr_zero(word)));
      }
    }
  }

 private:
  std::vector<std::uint64_t> words_;
  std::uint64_t count_ = 0;
};

std::string folder_for(const DetectRequest& request) {
  if (!request.temporary.empty()) return request.temporary;
  const char* const said = std::getenv("TMPDIR");
  return said != nullptr && *said != '\0' ? said : "/var/tmp";
}

void append_pair(io::TableWriter& table, const LargePair& pair, double distance_m) {
  table.field(pair.first).field(pair.second).field(distance_m);
  table.end_row();
}

class Detecting {
 public:
  Detecting(const DetectRequest& request, io::AtomicOutput& output)
      : request_(request), output_(output), bar_(!request.quiet), search_(options()) {}

  Result<ExitCode> run() {
    io::LoadOptions load = request_.load;
    auto stream = io::PointStream::open(request_.input, load);
    if (!stream) return std::move(stream).error();
    if (stream->frame() == io::Frame::kWgs84 && request_.vertical) {
      return usage_error("detect", "--memory takes --vertical of positions in metres only");
    }
    if (auto status = take(*stream); !status) return std::move(status).error();
    read_s_ = watch_.lap();
    if (auto status = find(); !status) return std::move(status).error();
    search_s_ = watch_.lap();
    const Status written = output_.commit();
    if (!written && output_.pipe_closed()) return ExitCode::kPipeClosed;
    if (!written) return written.error();
    bar_.finish();
    if (!request_.quiet) say(summary(*stream));
    return request_.fail_on_risk && is_risky_ ? ExitCode::kRiskFound : ExitCode::kFine;
  }

 private:
  OutOfCoreOptions options() {
    OutOfCoreOptions options;
    options.memory_bytes = *request_.memory_bytes;
    options.folder = folder_for(request_);
    options.threads = request_.search.threads;
    options.progress = [this](const OutOfCoreProgress& progress) {
      const bool first = progress.phase == OutOfCoreProgress::Phase::kDistributing;
      bar_.enter_stage(first ? "distributing" : "searching");
      bar_.set_share(static_cast<double>(progress.done) / static_cast<double>(progress.of));
    };
    return options;
  }

  Status take(io::PointStream& stream) {
    if (const auto view = stream.in_place()) return search_.refer(*view);
    std::vector<Point> points;
    for (;;) {
      if (auto status = stream.next(points); !status) return status;
      if (points.empty()) break;
      if (auto status = search_.add(points); !status) return status;
    }
    if (search_.size() > 0) return std::monostate{};
    Error error{ErrorCode::kNoPoints, "no record is there", {}};
    error.location.source = request_.input;
    return error;
  }

  Status find() {
    const std::string_view report = request_.report->name;
    if (report == "pairs") return find_pairs();
    return report == "closest-pair" ? find_closest_pair() : find_at_risk();
  }

  Status find_at_risk() {
    Flags at_risk(search_.size());
    auto status = search_.find_at_risk(request_.search.without_limit(),
                                       [&](std::span<const LargeId> ids) { at_risk.set(ids); });
    if (!status) return status;
    bar_.enter_stage("writing");
    BlockWriter out(output_);
    std::array<char, 24> digits{};
    at_risk.for_each([&](LargeId id) {
      char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), id).ptr;
      out.text.append(digits.data(), end) += '\n';
      out.pass_on();
    });
    is_risky_ = at_risk.count() > 0;
    finding_ = is_risky_ ? red(io::grouped(at_risk.count()) + " (" +
                               io::percentage(share(at_risk.count())) + ")")
                         : bold("none");
    return std::monostate{};
  }

  Status find_pairs() {
    BlockWriter out(output_);
    io::TableWriter table(out.text, '\t');
    table.header("first,second,distance_m").end_row();
    std::uint64_t count = 0;
    auto status = search_.visit_pairs(
        request_.search.without_limit(),
        [&](std::span<const LargePair> pairs, std::span<const double> distances_m) {
          count += pairs.size();
          for (std::size_t at = 0; at < pairs.size(); ++at) {
            append_pair(table, pairs[at], distances_m[at]);
            out.pass_on();
          }
        });
    is_risky_ = count > 0;
    finding_ = io::grouped(count) + " too close";
    return status;
  }

  Status find_closest_pair() {
    BlockWriter out(output_);
    io::TableWriter table(out.text, '\t');
    table.header("first,second,distance_m").end_row();
    const auto closest = search_.find_closest_pair();
    if (!closest) return closest.error();
    if (!*closest) {
      finding_ = "none: there is one point only";
      return std::monostate{};
    }
    const auto& [pair, distance_m] = **closest;
    append_pair(table, pair, distance_m);
    finding_ = std::to_string(pair.first) + " and " + std::to_string(pair.second) + ", " +
               io::length(distance_m) + " apart";
    return std::monostate{};
  }

  [[nodiscard]] double share(std::uint64_t count) const {
    return static_cast<double>(count) / static_cast<double>(search_.size());
  }

  [[nodiscard]] std::string summary(const io::PointStream& stream) const {
    const bool degrees = stream.frame() == io::Frame::kWgs84;
    const OutOfCoreFacts facts = search_.facts();
    std::string out;
    append_summary_line(out, "input",
                        printable(request_.input) + " (" + io::byte_count(stream.bytes()) + ", " +
                            stream.format_description() + ")");
    append_summary_line(out, "frame",
                        std::string(degrees ? "WGS84 longitude, latitude, height" : "metres") +
                            ": " + printable(stream.frame_reason()));
    append_summary_line(out, "points", io::grouped(search_.size()));
    append_summary_line(out, "threshold",
                        separation_text(request_.search.threshold_m, request_.search.vertical_m,
                                        request_.search.inclusive) +
                            (!request_.threshold_m ? kDefaultThresholdWords : ""));
    append_summary_line(out, request_.report->label, finding_);
    std::string cells = io::grouped(facts.cells) + (facts.cells == 1 ? " cell" : " cells");
    if (facts.crowded_cells > 0) {
      cells += ", " + io::grouped(facts.crowded_cells) +
               " of them too full for --memory: searched in pieces, which takes longer";
    }
    append_summary_line(out, "memory", io::byte_count(*request_.memory_bytes) + ", " + cells);
    append_summary_line(out, "time",
                        "read " + io::duration(read_s_) + ", search " + io::duration(search_s_));
    return out;
  }

  const DetectRequest& request_;
  io::AtomicOutput& output_;
  ProgressBar bar_;
  OutOfCore search_;
  Stopwatch watch_;
  double read_s_ = 0.0;
  double search_s_ = 0.0;
  bool is_risky_ = false;
  std::string finding_;
};

}  // namespace

Status check_out_of_core(const DetectRequest& request) {
  const std::string_view report = request.report->name;
  const struct {
    const char* what;
    bool fits;
  } table[] = {
      {"standard input: name a file", request.input != "-"},
      {"--others", !request.others},
      {"--skip-bad", !request.load.skip_bad},
      {"--unique-ids", !request.unique_ids},
      {"--max-results", !request.max_results},
      {"--vertical with closest-pair", !request.vertical || report != "closest-pair"},
      {"--fail-on-risk with closest-pair", !request.fail_on_risk || report != "closest-pair"},
      {"--csv, --json or --geojson: the answer is text", request.form.form == Form::kText},
      {"this report: it finds at-risk, pairs and closest-pair",
       report == "at-risk" || report == "pairs" || report == "closest-pair"}};
  for (const auto& [what, fits] : table) {
    if (!fits) return usage_error("detect", std::string("--memory does not take ") + what);
  }
  return std::monostate{};
}

Result<ExitCode> run_detect_out_of_core(const DetectRequest& request) {
  auto output = open_output("detect", request.output, {request.input}, request.form.packing);
  if (!output) return std::move(output).error();
  return Detecting(request, *output).run();
}

}  // namespace beespace::cli
