#include "cli/recorded/replay_out_of_core.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/coarse_places.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/track_ends.hpp"
#include "analysis/recorded/tracks.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/input/temporary_folder.hpp"
#include "cli/output/output_file.hpp"
#include "cli/recorded/large_apart.hpp"
#include "cli/recorded/replay_answer.hpp"
#include "cli/recorded/replay_summary.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/bytes/worker_threads.hpp"
#include "io/stream_recording.hpp"

#include <beespace/recording_out_of_core.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// What a block of text takes while it is read: the text, and its fixes twice.
constexpr std::uint64_t kTimesABlock = 8;

std::size_t block_for(std::uint64_t memory_bytes) {
  constexpr std::uint64_t kLeast = std::uint64_t{1} << 17U;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 23U;
  return static_cast<std::size_t>(std::clamp(memory_bytes / 128, kLeast, kMost));
}

OutOfCoreOptions options_of(const ReplayRequest& request, ProgressBar& bar) {
  const std::uint64_t memory_bytes = *request.memory_bytes;
  const std::uint64_t reading = kTimesABlock * block_for(memory_bytes);
  // What the library needs; below that it says so.
  const std::uint64_t least =
      OutOfCoreOptions::kLeastMemoryBytes * io::thread_count(request.moving.threads);
  OutOfCoreOptions options;
  options.memory_bytes =
      std::max(std::min(memory_bytes, least), memory_bytes - std::min(memory_bytes, reading));
  options.folder = temporary_folder(request.temporary);
  options.threads = request.moving.threads;
  options.progress = [&bar](const OutOfCoreProgress& progress) {
    const bool searching = progress.phase == OutOfCoreProgress::Phase::kSearching;
    bar.enter_stage(searching ? "searching" : "sorting");
    bar.set_share(static_cast<double>(progress.done) / static_cast<double>(progress.of));
  };
  return options;
}

class Replaying {
 public:
  Replaying(const ReplayRequest& request, io::AtomicOutput& output, ProgressBar& bar,
            io::RecordingStream& stream)
      : request_(request),
        moving_(request.moving),
        output_(output),
        bar_(bar),
        stream_(stream),
        fixes_(options_of(request, bar)) {
    // As in memory: what is said twice counts once, and is told.
    fixes_.allow_repeated(true);
  }

  Result<ExitCode> run() {
    if (auto status = read(); !status) return std::move(status).error();
    read_s_ = watch_.lap();
    bar_.enter_stage("searching");
    if (auto status = search(); !status) return std::move(status).error();
    if (auto status = look_apart(); !status) return std::move(status).error();
    search_s_ = watch_.lap();
    bar_.enter_stage("writing");
    return write();
  }

 private:
  Status read() {
    std::vector<io::StreamedFix> block;
    while (true) {
      if (auto status = stream_.next(block); !status) return status;
      if (block.empty()) break;
      if (auto status = add(block); !status) return status;
    }
    // Of each bee the first fix and the last one: all that is told of it but its conflicts.
    std::vector<LargeAgent> agents;
    Status told = fixes_.visit_agents([&](const LargeAgent& agent) { agents.push_back(agent); });
    if (!told) return placed(std::move(told).error());
    any_velocity_ = stream_.any_velocity();
    auto recording = stream_.finish(fixes_.facts().repeated);
    if (!recording) return std::move(recording).error();
    recording_ = *std::move(recording);
    if (auto doubt = analysis::doubt_of_scale(
            {recording_.units, recording_.frame, moving_.load.frame == io::Frame::kMetres}, spread_,
            moving_.threshold, analysis::kWithScale)) {
      return *std::move(doubt);
    }
    recording_.reach = {spread_.least(), spread_.greatest()};
    intervals_.resize(recording_.bees.size());
    tracks_.resize(recording_.bees.size());
    for (const LargeAgent& agent : agents) {
      std::vector<Fix> ends = {{agent.begins_s, {}}};
      if (agent.fixes > 1) ends.push_back({agent.ends_s, {}});
      tracks_[agent.id].fixes = std::move(ends);
      recording_.bees[agent.id].fixes = ends_.of(agent.id);
      intervals_[agent.id] = {agent.fixes, agent.interval_s};
    }
    max_gap_ = analysis::max_gap_of(intervals_, request_.max_gap_s);
    return std::monostate{};
  }

  // In metres.
  Status add(const std::vector<io::StreamedFix>& block) {
    geometry_ = analysis::geometry_for(stream_.frame(), stream_.height_unit(), moving_.vertical);
    if (stream_.several_height_units() && analysis::heights_apart(geometry_)) {
      return Error{ErrorCode::kInvalidArgument,
                   "the files state heights in different units, which are compared in metres only "
                   "where all are read before; read them apart, or leave --memory out",
                   {}};
    }
    std::vector<AgentId> bees;
    std::vector<double> times_s;
    std::vector<Point> positions;
    std::vector<double> heights;
    for (const io::StreamedFix& each : block) {
      const analysis::StatedHeight stated =
          each.stated_height ? analysis::StatedHeight{*each.stated_height, stream_.height_unit()}
                             : analysis::StatedHeight{each.fix.position.z, io::Unit::kMetre};
      const auto at =
          analysis::in_metres(each.fix.position, std::nullopt, stream_.frame(), geometry_, stated);
      if (!at) return analysis::of_bee(at.error(), {stream_.id(each.bee), {}});
      ends_.add(each.bee, each.fix);
      spread_.add(each.fix.position);
      const auto bee = static_cast<std::size_t>(each.bee);
      if (bee >= steps_.size()) steps_.resize(bee + 1);
      steps_[bee].take(each.fix);
      bees.push_back(each.bee);
      times_s.push_back(each.fix.time_s);
      positions.push_back(at->position);
      if (analysis::heights_apart(geometry_)) heights.push_back(at->height_m);
    }
    const PointsView view = std::span<const Point>(positions);
    return fixes_.add(bees, times_s,
                      analysis::heights_apart(geometry_) ? view.with_heights(heights) : view);
  }

  // An error about two fixes of a bee, with the place that they came from.
  Error placed(Error error) const {
    const auto clash = fixes_.facts().clash;
    if (error.code != ErrorCode::kTimeOrder || !clash) return error;
    return stream_.clash(static_cast<std::size_t>(clash->agent), clash->time_s, clash->first_row,
                         clash->second_row);
  }

  Status search() {
    if (auto needed = analysis::threshold_needed(recording_, moving_.threshold, moving_.vertical)) {
      return *std::move(needed);
    }
    threshold_m_ = moving_.threshold_m.value_or(
        analysis::default_threshold(recording_, kDefaultThreshold_m).metres);
    const ConflictOptions options = {
        .threshold_m = threshold_m_,
        .vertical_m = analysis::vertical_in(geometry_, moving_.vertical, stream_.height_unit()),
        .inclusive = moving_.inclusive,
        .max_gap_s = max_gap_.seconds,
        .max_results = moving_.max_results,
        .height_unit_m = analysis::height_unit_m(geometry_, recording_.height_unit)};
    const Status found = fixes_.find_conflicts(
        options,
        [&](std::span<const LargeConflict> some) {
          for (const LargeConflict& c : some) {
            found_.conflicts.push_back({static_cast<PointId>(c.first),
                                        static_cast<PointId>(c.second), c.begins_s, c.closest_s,
                                        c.ends_s, c.closest_m});
          }
        },
        [&](std::span<const LargeGap> some) {
          for (const LargeGap& gap : some) {
            found_.gaps.push_back({static_cast<PointId>(gap.agent), gap.begins_s, gap.ends_s});
          }
        });
    if (!found) return in_words_of_the_command(found.error(), moving_);
    facts_ = fixes_.facts();
    analysis::doubt_shared_ids(recording_, found_.conflicts);
    const auto worst = std::min_element(
        found_.conflicts.begin(), found_.conflicts.end(),
        [](const Conflict& a, const Conflict& b) { return a.closest_m < b.closest_m; });
    if (worst != found_.conflicts.end()) closest_ = *worst;
    return std::monostate{};
  }

  // Where two were when they were closest, which the search does not keep.
  Status look_apart() {
    distances_ = distances_of(moving_, recording_, threshold_m_);
    if (!moving_.vertical) return std::monostate{};
    auto apart = large_apart_of(fixes_, found_.conflicts, tracks_,
                                {analysis::heights_apart(geometry_),
                                 analysis::height_unit_m(geometry_, recording_.height_unit)});
    if (!apart) return std::move(apart).error();
    distances_.apart = *std::move(apart);
    return std::monostate{};
  }

  Result<ExitCode> write() {
    analysis::Coverage coverage =
        analysis::coverage_of(recording_, found_.gaps, max_gap_, intervals_);
    // Who is closest of those without a conflict is not looked for.
    analysis::judge_places(steps_, recording_.frame,
                           {threshold_m_, !found_.conflicts.empty(), threshold_m_, false},
                           coverage);
    if (coverage.coarse == 0) {
      analysis::judge_accuracy(recording_.accuracy,
                               {threshold_m_, !found_.conflicts.empty(), threshold_m_, false},
                               coverage);
    }
    analysis::Findings findings{recording_, tracks_,  tracks_,          found_,
                                closest_,   coverage, facts_.encounters};
    findings.velocities_passed_over = any_velocity_ && !request_.straight;
    const JsonHead head = [&](io::JsonWriter& json) {
      write_findings(json, findings, request_, threshold_m_, distances_);
    };
    write_answer(rows_of(request_, findings, distances_), moving_, head, request_.report.c_str(),
                 output_);
    const Status written = output_.commit();
    if (!written && output_.pipe_closed()) return ExitCode::kPipeClosed;
    if (!written) return written.error();
    bar_.finish();
    if (!moving_.quiet) {
      say(replay_summary(findings, moving_,
                         {threshold_m_, read_s_, search_s_, request_.memory_bytes, facts_.windows},
                         distances_));
    }
    return moving_.fail_on_risk && findings.is_risky() ? ExitCode::kRiskFound : ExitCode::kFine;
  }

  const ReplayRequest& request_;
  const MovingRequest& moving_;
  io::AtomicOutput& output_;
  ProgressBar& bar_;
  io::RecordingStream& stream_;
  RecordingOutOfCore fixes_;
  analysis::Geometry geometry_ = analysis::Geometry::kSpace;
  analysis::TrackEnds ends_;
  io::Recording recording_;                       // of each bee the first fixes and the last ones
  std::vector<Track> tracks_;                     // the first and the last, without positions
  std::vector<analysis::BeeInterval> intervals_;  // by bee
  analysis::MaxGap max_gap_{std::numeric_limits<double>::infinity(), std::nullopt};
  double threshold_m_ = 0.0;
  RecordedConflicts found_;
  std::optional<Conflict> closest_;  // of the conflicts
  RecordingOutOfCoreFacts facts_;    // of the search
  Distances distances_;
  analysis::Spread spread_;                  // of places as they are read
  std::vector<analysis::PlaceSteps> steps_;  // of places as they are read, by bee
  bool any_velocity_ = false;
  Stopwatch watch_;
  double read_s_ = 0.0;
  double search_s_ = 0.0;
};

}  // namespace

Result<ExitCode> run_replay_out_of_core(const ReplayRequest& request) {
  const MovingRequest& moving = request.moving;
  auto output = open_output("replay", moving.output, moving.inputs, moving.form.packing);
  if (!output) return std::move(output).error();
  ProgressBar bar(!moving.quiet);
  io::RecordingOptions load = moving.load;
  load.progress = &bar.reading();
  auto stream = io::RecordingStream::open(moving.inputs, load, block_for(*request.memory_bytes));
  if (!stream) return std::move(stream).error();
  return Replaying(request, *output, bar, *stream).run();
}

}  // namespace beespace::cli
