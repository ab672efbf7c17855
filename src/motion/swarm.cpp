#include <beespace/swarm.hpp>

#include "cpu/crew_size.hpp"
#include "motion/live_bees.hpp"
#include "motion/live_walks.hpp"
#include "motion/prediction.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

namespace beespace {

namespace {

std::optional<Error> check(const SwarmOptions& options) {
  if (auto error = motion::check_separation(options.threshold_m, options.vertical_m)) return error;
  if (auto error = motion::check_heights(options.heights_apart, options.vertical_m)) return error;
  if (auto error = motion::check_height_unit(options.height_unit_m)) return error;
  const auto good = [](double value, double least) {
    return value >= least && motion::in_motion_domain(value);
  };
  if (good(options.leave_factor, 1.0) && good(options.horizon_s, 0.0) &&
      good(options.max_age_s, kSmallestInMotion)) {
    return std::nullopt;
  }
  return Error{ErrorCode::kInvalidArgument,
               "leave_factor must be 1 or more, horizon_s 0 or more, max_age_s above 0, and all of "
               "them finite",
               {}};
}

motion::Separation separation_of(const SwarmOptions& options, double factor) {
  motion::Separation separation{
      options.threshold_m * factor, {}, false, options.heights_apart, options.height_unit_m};
  if (options.vertical_m) separation.vertical_m = *options.vertical_m * factor;
  return separation;
}

// A pair of bees, the lower id first.
struct BeePair {
  PointId first;
  PointId second;

  friend auto operator<=>(const BeePair&, const BeePair&) = default;  // NOLINT(*-use-nullptr)
};

bool earlier(const SwarmEvent& a, const SwarmEvent& b) {
  return std::tie(a.time_s, a.kind, a.first, a.second) <
         std::tie(b.time_s, b.kind, b.first, b.second);
}

}  // namespace

// What is inside is not for export.
class __attribute__((visibility("hidden"))) Swarm::State {
 public:
  explicit State(const SwarmOptions& options)
      : options_(options),
        enter_(separation_of(options, 1.0)),
        leave_(separation_of(options, options.leave_factor)),
        bees_(options.heights_apart),
        walks_({leave_, enter_, options.leave_factor == 1.0},
               std::max(0.05, options.leave_factor - 1.0) * options.threshold_m) {}

  Status update(const Report& report);
  void remove(PointId id) { bees_.remove(id); }
  Result<std::vector<SwarmEvent>> advance(double now_s);

  [[nodiscard]] SwarmCounts counts() const {
    SwarmCounts counts = counts_;
    counts.bees = bees_.under_way();
    counts.stale = bees_.stale();
    return counts;
  }
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const;

 private:
  core::Resources resources();
  Status predict(double now_s, const core::Resources& with, std::vector<SwarmEvent>& events);

  SwarmOptions options_;
  motion::Separation enter_;
  motion::Separation leave_;
  motion::LiveBees bees_;
  motion::LiveWalks walks_;
  std::vector<BeePair> predicted_;  // said, and still in danger; ascending
  std::optional<double> now_s_;
  SwarmCounts counts_;
  core::Memory memory_;
  Crew alone_;
  std::optional<ThreadCrew> crew_;
};

Status Swarm::State::update(const Report& report) {
  if (auto error = check(options_)) return *std::move(error);
  const Mover mover{report.position, report.velocity.value_or(Velocity{})};
  if (auto error = motion::check_mover(mover, report.id)) return *std::move(error);
  if (auto error = motion::check_height(report.height_m, report.climb_mps, report.id)) {
    return *std::move(error);
  }
  if (!motion::in_motion_domain(report.time_s)) {
    Place place;
    place.record = report.id;
    return Error{std::isfinite(report.time_s) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite,
                 "the time of the report is " + std::to_string(report.time_s) +
                     " s; give a finite number of seconds",
                 place};
  }
  switch (bees_.take(report, options_.max_age_s)) {
    case motion::LiveBees::Taken::kYes:
      ++counts_.taken;
      break;
    case motion::LiveBees::Taken::kRepeated:
      ++counts_.repeated;
      break;
    case motion::LiveBees::Taken::kLate:
      ++counts_.late;
      break;
  }
  return std::monostate{};
}

core::Resources Swarm::State::resources() {
  memory_.start_call();
  const unsigned size = cpu::crew_size(options_.threads, bees_.under_way());
  if (size == 1) return {alone_, memory_};
  if (!crew_ || crew_->size() != size) crew_.emplace(size);
  return {*crew_, memory_};
}

Result<std::vector<SwarmEvent>> Swarm::State::advance(double now_s) {
  if (auto error = check(options_)) return *std::move(error);
  if (!motion::in_motion_domain(now_s) || now_s < now_s_.value_or(now_s)) {
    return Error{std::isfinite(now_s) ? ErrorCode::kTimeOrder : ErrorCode::kNotFinite,
                 "cannot advance to " + std::to_string(now_s) +
                     " s; give a time that is not before the last",
                 {}};
  }
  now_s_ = now_s;
  std::vector<SwarmEvent> events;
  bees_.complete_stale(now_s - options_.max_age_s, [&](PointId bee, double last_s) {
    events.push_back({EventKind::kStale, last_s, bee, bee, 0.0, last_s});
  });
  const core::Resources with = resources();
  walks_.search(bees_, with, events);
  if (options_.horizon_s > 0.0) {
    const Status predicted = predict(now_s, with, events);
    if (!predicted) return predicted.error();
  }
  std::sort(events.begin(), events.end(), earlier);
  return events;
}

// A pair stays predicted as long as it is predicted by the leave threshold; it becomes so by that
// of entering.
Status Swarm::State::predict(double now_s, const core::Resources& with,
                             std::vector<SwarmEvent>& events) {
  std::vector<Mover> movers;
  std::vector<double> heights_m;
  std::vector<double> climbs_mps;
  std::vector<PointId> ids;
  for (const motion::LiveRun& run : bees_.runs()) {
    if (run.fixes.empty()) continue;
    const auto now = run.at(now_s);
    if (!now) continue;
    movers.push_back(now->mover);
    ids.push_back(run.bee);
    if (!options_.heights_apart) continue;
    heights_m.push_back(now->height_m);
    climbs_mps.push_back(now->climb_mps);
  }
  const MoversView all(movers);
  const MoversView view(all.positions(), all.velocities(), heights_m, climbs_mps);
  const PredictOptions wide{.threshold_m = leave_.threshold_m,
                            .vertical_m = leave_.vertical_m,
                            .horizon_s = options_.horizon_s};
  std::vector<Pair> pairs;
  Status found = motion::predict_pairs(view, wide, with, pairs);
  if (!found) return found;
  std::vector<BeePair> still;
  for (const Pair& pair : pairs) {
    PointId a = ids[pair.first];
    PointId b = ids[pair.second];
    if (a > b) std::swap(a, b);
    const bool said = std::binary_search(predicted_.begin(), predicted_.end(), BeePair{a, b});
    const motion::State first = motion::state_of(view, pair.first);
    const motion::State second = motion::state_of(view, pair.second);
    if (!said && !motion::in_conflict(first, second, enter_, options_.horizon_s)) continue;
    still.push_back({a, b});
    if (said || walks_.have_entered(a, b)) continue;
    const auto report =
        motion::report_conflict(motion::relative_motion(first, second), enter_, options_.horizon_s);
    events.push_back({EventKind::kPredicted, now_s + report.span.begins_s, a, b, report.closest_m,
                      now_s + report.closest_s});
  }
  std::sort(still.begin(), still.end());
  predicted_ = std::move(still);
  return std::monostate{};
}

std::vector<LiveMover> Swarm::State::movers(double time_s) const {
  std::vector<LiveMover> movers;
  if (!motion::in_motion_domain(time_s)) return movers;
  for (const motion::LiveRun& run : bees_.runs()) {
    if (run.complete || run.fixes.empty()) continue;
    if (const auto now = run.at(time_s)) movers.push_back({run.bee, now->mover});
  }
  std::sort(movers.begin(), movers.end(),
            [](const LiveMover& a, const LiveMover& b) { return a.id < b.id; });
  return movers;
}

Swarm::Swarm(const SwarmOptions& options) : state_(std::make_unique<State>(options)) {
}
Swarm::Swarm(Swarm&&) noexcept = default;
Swarm& Swarm::operator=(Swarm&&) noexcept = default;
Swarm::~Swarm() = default;

Status Swarm::update(const Report& report) {
  return state_->update(report);
}

void Swarm::remove(PointId id) {
  state_->remove(id);
}

Result<std::vector<SwarmEvent>> Swarm::advance(double now_s) {
  return state_->advance(now_s);
}

SwarmCounts Swarm::counts() const {
  return state_->counts();
}

std::vector<LiveMover> Swarm::movers(double time_s) const {
  return state_->movers(time_s);
}

}  // namespace beespace
