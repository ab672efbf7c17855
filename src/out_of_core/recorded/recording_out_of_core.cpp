// The class RecordingOutOfCore.
#include <beespace/recording_out_of_core.hpp>

#include "base/kept_crew.hpp"
#include "base/memory.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "motion/validate.hpp"
#include "out_of_core/recorded/clash_error.hpp"
#include "out_of_core/recorded/interval_median.hpp"
#include "out_of_core/recorded/recording_plan.hpp"
#include "out_of_core/recorded/stored_fixes.hpp"
#include "out_of_core/recorded/window_search.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace {

namespace {

using namespace out_of_core;  // NOLINT(google-build-using-namespace): its own room

Error invalid(std::string what, const char* array = "") {
  Error error{ErrorCode::kInvalidArgument, std::move(what), {}};
  error.location.array = array;
  return error;
}

}  // namespace

class __attribute__((visibility("hidden"))) RecordingOutOfCore::State {
 public:
  explicit State(const OutOfCoreOptions& options) : options_(options), crew_(nullptr) {}

  Status add(std::span<const AgentId> agents, std::span<const double> times_s,
             const PointsView& positions) {
    if (auto error = unusable()) return *std::move(error);
    if (auto error = wrong_arrays(agents, times_s, positions)) return *std::move(error);
    auto status = fixes_->add(agents, times_s, positions, crew());
    if (!status && status.error().code == ErrorCode::kWriteFailed) broken_ = status.error();
    return status;
  }

  [[nodiscard]] std::uint64_t size() const { return fixes_ ? fixes_->size() : 0; }
  void set_run(const RunOptions& run) {
    options_.threads = run.threads;
    options_.stop = run.stop;
  }
  void allow_repeated(bool allowed) { repeats_allowed_ = allowed; }
  [[nodiscard]] const RecordingOutOfCoreFacts& facts() const { return facts_; }

  Status visit_agents(const LargeAgentVisitor& visit) {
    facts_ = {};
    if (auto status = settle(); !status) return status;
    RepeatedFixes repeated{repeats_allowed_, 0, {}};
    IntervalMedian intervals(options_.folder, plan_->intervals, crew());
    std::optional<LargeAgent> agent;
    Status done = std::monostate{};
    const auto end = [&] {
      if (!agent) return;
      const auto median = intervals.take();
      if (!median) {
        done = median.error();
        return;
      }
      agent->interval_s = *median;
      visit(*agent);
    };
    std::uint64_t read = 0;
    auto status = fixes_->for_each(repeated, [&](const StoredFix& fix) {
      const double time_s = fix.fix.time_s;
      if (agent && agent->id == fix.agent) {
        done = intervals.add(time_s - agent->ends_s);
        agent->ends_s = time_s;
        ++agent->fixes;
      } else {
        end();
        agent = {fix.agent, 1, time_s, time_s, 0.0};
      }
      if (++read % kFixesBetweenStops == 0 && options_.stop.stop_requested()) {
        done = core::stopped_error();
      }
      return done.has_value();
    });
    if (!status) return status;
    if (done) end();
    facts_.repeated = repeated.count;
    facts_.clash = repeated.clash;
    if (done && repeated.clash) return clash_error(*repeated.clash);
    return done;
  }

  Status visit_fixes(const LargeFixVisitor& visit) {
    facts_ = {};
    if (auto status = settle(); !status) return status;
    RepeatedFixes repeated{repeats_allowed_, 0, {}};
    std::vector<LargeFix> told;
    told.reserve(kFixesAtOnce);
    std::uint64_t read = 0;
    bool stopped = false;
    auto status = fixes_->for_each(repeated, [&](const StoredFix& fix) {
      told.push_back({fix.agent, fix.fix, fix.height_m});
      if (told.size() == kFixesAtOnce) {
        visit(told);
        told.clear();
      }
      stopped = ++read % kFixesBetweenStops == 0 && options_.stop.stop_requested();
      return !stopped;
    });
    if (!status) return status;
    if (stopped) return core::stopped_error();
    if (!told.empty()) visit(told);
    facts_.repeated = repeated.count;
    facts_.clash = repeated.clash;
    if (repeated.clash) return clash_error(*repeated.clash);
    return std::monostate{};
  }

  Status find_conflicts(const ConflictOptions& options, const LargeConflictVisitor& conflicts,
                        const LargeGapVisitor& gaps) {
    facts_ = {};
    if (auto error = motion::check_options(options)) return *std::move(error);
    const bool heights = fixes_ && fixes_->have_heights();
    if (auto error = motion::check_heights(heights, options.vertical_m)) return *std::move(error);
    if (auto status = settle(); !status) return status;
    if (size() == 0) return std::monostate{};
    const RecordingWorkplace at{*plan_, options_.folder, crew(), options_.stop, options_.progress};
    return search_windows(*fixes_, options, repeats_allowed_, at, conflicts, gaps, facts_);
  }

 private:
  static constexpr std::uint64_t kFixesBetweenStops = std::uint64_t{1} << 14U;
  static constexpr std::size_t kFixesAtOnce = 1024;

  Crew& crew() { return crew_.of(options_.threads, std::numeric_limits<std::size_t>::max()); }

  // What makes every call an error. Makes the plan for the memory and the threads.
  std::optional<Error> unusable() {
    if (broken_) return broken_;
    if (options_.folder.empty()) return invalid("a folder for temporary files must be named");
    auto plan = recording_plan_for(options_.memory_bytes, crew().size());
    if (!plan) return std::move(plan).error();
    plan_ = *plan;
    if (!fixes_) fixes_.emplace(options_.folder, plan_->fixes);
    return std::nullopt;
  }

  Status settle() {
    if (auto error = unusable()) return *std::move(error);
    if (options_.stop.stop_requested()) return core::stopped_error();
    auto status = fixes_->settle(crew());
    if (!status) broken_ = status.error();
    core::trim_freed_memory(plan_->fixes.buffer_bytes);
    return status;
  }

  [[nodiscard]] std::optional<Error> wrong_arrays(std::span<const AgentId> agents,
                                                  std::span<const double> times_s,
                                                  const PointsView& positions) const {
    if (!positions.fits()) return core::check_size(positions);
    if (auto error = core::check_height_count(positions)) return error;
    if (agents.size() != positions.size() || times_s.size() != positions.size()) {
      return invalid("there are " + std::to_string(agents.size()) + " agents and " +
                     std::to_string(times_s.size()) + " times for " +
                     std::to_string(positions.size()) +
                     " positions; give one of each for every "
                     "fix");
    }
    if (size() == 0 || positions.empty() || positions.has_heights() == fixes_->have_heights()) {
      return std::nullopt;
    }
    return invalid(positions.has_heights()
                       ? "these fixes have heights apart from their positions, and those that "
                         "came before have none; give them to all, or to none"
                       : "these fixes have no heights apart from their positions, and those that "
                         "came before have; give them to all, or to none");
  }

  OutOfCoreOptions options_;
  core::KeptCrew crew_;
  std::optional<RecordingPlan> plan_;
  std::optional<StoredFixes> fixes_;
  std::optional<Error> broken_;
  bool repeats_allowed_ = false;
  RecordingOutOfCoreFacts facts_;
};

RecordingOutOfCore::RecordingOutOfCore(const OutOfCoreOptions& options)
    : state_(std::make_unique<State>(options)) {
}
RecordingOutOfCore::RecordingOutOfCore(RecordingOutOfCore&&) noexcept = default;
RecordingOutOfCore& RecordingOutOfCore::operator=(RecordingOutOfCore&&) noexcept = default;
RecordingOutOfCore::~RecordingOutOfCore() = default;

Status RecordingOutOfCore::add(std::span<const AgentId> agents, std::span<const double> times_s,
                               const PointsView& positions) {
  return state_->add(agents, times_s, positions);
}

std::uint64_t RecordingOutOfCore::size() const {
  return state_->size();
}

void RecordingOutOfCore::set_run(const RunOptions& run) {
  state_->set_run(run);
}

void RecordingOutOfCore::allow_repeated(bool allowed) {
  state_->allow_repeated(allowed);
}

Status RecordingOutOfCore::visit_agents(const LargeAgentVisitor& visit) {
  return state_->visit_agents(visit);
}

Status RecordingOutOfCore::visit_fixes(const LargeFixVisitor& visit) {
  return state_->visit_fixes(visit);
}

Status RecordingOutOfCore::find_conflicts(const ConflictOptions& options,
                                          const LargeConflictVisitor& conflicts,
                                          const LargeGapVisitor& gaps) {
  return state_->find_conflicts(options, conflicts, gaps);
}

RecordingOutOfCoreFacts RecordingOutOfCore::facts() const {
  return state_->facts();
}

}  // namespace beespace
