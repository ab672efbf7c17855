#include <beespace/advise.hpp>
#include <beespace/crew.hpp>

#include "avoidance/advised_flight.hpp"
#include "avoidance/agent_states.hpp"
#include "avoidance/constraint_builder.hpp"
#include "avoidance/intake.hpp"
#include "avoidance/known_methods.hpp"
#include "avoidance/one_in_round.hpp"
#include "avoidance/plane_memory.hpp"
#include "avoidance/remembered_planes.hpp"
#include "avoidance/validate.hpp"
#include "avoidance/velocity_solver.hpp"
#include "avoidance/vicinity.hpp"
#include "base/dynamic_schedule.hpp"
#include "base/kept_crew.hpp"
#include "base/stopping.hpp"
#include "motion/flush.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace {

namespace {

using avoidance::AgentState;
using avoidance::AgentStates;
using avoidance::ConstraintBuilder;
using core::Vector3;

// Bees that a worker takes at a time: some have many neighbours, others none.
constexpr std::size_t kChunk = 512;

// The value as it will be read when it is passed in again.
Velocity velocity_of(const Vector3& v) {
  return motion::flushed(Velocity{v.x, v.y, v.z});
}

// An agent that wants to fly and is told to stand waits.
bool waits(const AgentState& agent, const Vector3& preferred, const Vector3& velocity) {
  constexpr double kStands = 0.05;  // of its greatest speed
  const double least = kStands * agent.max_speed;
  return length(velocity) < least && length(agent.velocity) < least &&
         length(preferred) > 4.0 * least;
}

// Lists each pair of bee and obstacle once, however many pieces the obstacle has; ascending.
void keep_nearest_pieces(std::vector<NearObstacle>& all) {
  const auto place = [](const NearObstacle& near) {
    return std::tuple(near.agent, near.obstacle, near.gap_m);
  };
  std::sort(all.begin(), all.end(),
            [&](const NearObstacle& a, const NearObstacle& b) { return place(a) < place(b); });
  const auto same = [](const NearObstacle& a, const NearObstacle& b) {
    return a.agent == b.agent && a.obstacle == b.obstacle;
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
}

}  // namespace

class __attribute__((visibility("hidden"))) Adviser::State {
 public:
  explicit State(Crew* lent) : near_(lent), crew_(lent) {}

  Status advise(const MoversView& movers, std::span<const Velocity> preferred,
                std::span<const FlightLimits> limits, const AdviseOptions& options,
                Advised& advised) {
    advised.clear();
    if (auto error = avoidance::check(movers, preferred, limits, options)) {
      return *std::move(error);
    }
    intake_.take(movers, preferred, limits, options, advised.refused);
    Status found = core::unless_stopped([&] { return advise_all(intake_.options(), advised); });
    if (!found) {
      advised.clear();
      return found;
    }
    intake_.number_as_given(advised);
    return std::monostate{};
  }

  Status advise_one(const AgentInRound& agent, std::span<const AgentInRound> others,
                    const AdviseOptions& options, Advice& advice) {
    advice = {};
    if (auto error = one_.take(agent, others, options)) return *std::move(error);
    const AdviseOptions& round = one_.options();
    if (auto error = avoidance::check(one_.movers(), one_.preferred(), one_.limits(), round)) {
      return *std::move(error);
    }
    Advised& advised = one_.advised();
    advised.clear();
    intake_.take(one_.movers(), one_.preferred(), one_.limits(), round, advised.refused);
    const std::optional<PointId> bee = one_.number_in(intake_);
    if (!bee) return one_.refusal();
    advise_alone(*bee, one_.too_close(intake_), one_.ids(), intake_.options(), advised);
    advice = advised.advice[*bee];
    return std::monostate{};
  }

 private:
  // Advises the agent of this number among those that were taken, which are all that it may meet.
  void advise_alone(PointId bee, std::span<const char> too_close, std::span<const PointId> ids,
                    const AdviseOptions& options, Advised& advised) {
    Crew& crew = crew_.of(1, 1);
    clear_desks(crew.size());
    agents_.take(intake_.movers(), intake_.preferred(), intake_.limits(), options, crew);
    near_.take_all(agents_.size());
    const avoidance::RememberedPlanes planes =
        start_planes(options, std::size_t{ids.back()} + 1, ids, true);
    const ConstraintBuilder constraint_builder(agents_, near_, too_close, intake_.preferred(),
                                               planes, options);
    advised.advice.assign(agents_.size(), {});
    const Vector3 wanted = core::vector_of(intake_.preferred()[bee]);
    advised.advice[bee] = advise_one(bee, wanted, constraint_builder, desks_.front());
    if (options.planes != nullptr) options.planes->state().finish();
    finish(bee, constraint_builder, options, advised);
  }

  // The working memory of one thread.
  struct Desk {
    ConstraintBuilder::Findings findings;
    avoidance::VelocitySolver solver;
    avoidance::KnownMethod known;
  };

  // Advises all valid bees, which are numbered without the others here.
  Status advise_all(const AdviseOptions& options, Advised& advised) {
    const std::span<const Velocity> preferred = intake_.preferred();
    const std::size_t bees = intake_.movers().size();
    core::StoppableCrew crew(crew_.of(options.threads, bees), options.stop);
    clear_desks(crew.size());
    agents_.take(intake_.movers(), preferred, intake_.limits(), options, crew);
    const double horizon_s = avoidance::looks_ahead_s(agents_, options.step_s);
    if (Status found = find_near(options, horizon_s, crew); !found) return found;
    advised.advice.assign(bees, {});
    too_close_.assign(bees, 0);
    const avoidance::RememberedPlanes planes =
        start_planes(options, intake_.bees_given(), {}, false);
    const ConstraintBuilder constraint_builder(agents_, near_, too_close_, preferred, planes,
                                               options);
    if (options.method == AdviseMethod::kCertified) {
      cpu::schedule(crew, bees, kChunk, [&](auto begin, auto end, unsigned /*worker*/) {
        for (std::size_t bee = begin; bee < end; ++bee) {
          constraint_builder.mark_too_close(static_cast<PointId>(bee), too_close_);
        }
      });
    }
    cpu::schedule(crew, bees, kChunk, [&](auto begin, auto end, unsigned worker) {
      Desk& desk = desks_[worker];
      for (std::size_t bee = begin; bee < end; ++bee) {
        const auto id = static_cast<PointId>(bee);
        const Vector3 wanted = core::vector_of(preferred[bee]);
        advised.advice[bee] = options.method == AdviseMethod::kCertified
                                  ? advise_one(id, wanted, constraint_builder, desk)
                                  : known_advice(id, wanted, options, horizon_s, desk);
      }
    });
    if (options.planes != nullptr) options.planes->state().finish();
    collect(constraint_builder, options, advised);
    return std::monostate{};
  }

  [[nodiscard]] avoidance::RememberedPlanes start_planes(const AdviseOptions& options,
                                                         std::size_t ids_below,
                                                         std::span<const PointId> ids,
                                                         bool of_one) const {
    if (options.planes == nullptr) return {};
    PlaneMemory::State& memory = options.planes->state();
    memory.start(ids_below);
    return {&memory, intake_.given_bees(), ids, of_one};
  }

  Status find_near(const AdviseOptions& options, double horizon_s, Crew& crew) {
    if (options.method == AdviseMethod::kCertified) return near_.find(agents_, crew);
    const RunOptions run{options.threads, options.stop};
    const double within_m = agents_.apart().kept_m + 2.0 * agents_.fastest() * horizon_s;
    return near_.find_within(MoversView(intake_.movers()).positions(), within_m, run);
  }

  void clear_desks(std::size_t workers) {
    desks_.resize(workers);
    for (Desk& desk : desks_) {
      desk.findings.too_close.clear();
      desk.findings.near_obstacle.clear();
      desk.findings.near_fence.clear();
      desk.findings.near_unknown.clear();
    }
  }

  [[nodiscard]] Advice advise_one(PointId bee, const Vector3& preferred,
                                  const ConstraintBuilder& constraint_builder, Desk& desk) const {
    constexpr double kAside = 0.5;  // of its greatest speed: how fast an idle agent makes room
    const AgentState& agent = agents_[bee];
    ConstraintBuilder::Findings& findings = desk.findings;
    constraint_builder.look_at(bee, findings);
    if (agents_.claims().holds(bee)) return held(agent, findings);
    const bool makes_room = constraint_builder.is_idle(bee) && !(findings.pressed == Vector3{});
    const Vector3 aside = at_most(findings.pressed, 1.0) * (kAside * agent.max_speed);
    const auto [velocity, kind] =
        desk.solver.solve(agent, makes_room ? preferred + aside : preferred, findings.constraints);
    Advice advice = advice_of(velocity, kind, findings);
    if (kind == AdviceKind::kAsPreferred) {
      if (makes_room) advice.kind = AdviceKind::kDeflected;
    } else if (findings.certified && waits(agent, preferred, velocity)) {
      advice.kind = AdviceKind::kWaiting;
    }
    return advice;
  }

  [[nodiscard]] Advice advice_of(const Vector3& velocity, AdviceKind kind,
                                 const ConstraintBuilder::Findings& findings) const {
    Advice advice{velocity_of(velocity), kind};
    advice.keeps_apart = findings.certified;
    advice.clear_of_unknown_s = intake_.bee_anywhere() ? 0.0 : findings.clear_of_unknown_s;
    advice.clear_of_unknown = advice.clear_of_unknown_s >= intake_.options().unknown_horizon_s;
    advice.clear_of_intruders = !intake_.intruder_anywhere();  // until a conflict is found
    return advice;
  }

  // It gets nothing new: it does what it was told before, within its claim.
  [[nodiscard]] Advice held(const AgentState& agent,
                            const ConstraintBuilder::Findings& findings) const {
    const avoidance::Braking& braking = agent.braking;
    const Vector3 velocity = braking.at_once() ? Vector3{} : braking.braked(agent.velocity);
    return advice_of(velocity, AdviceKind::kBraking, findings);
  }

  [[nodiscard]] Advice known_advice(PointId bee, const Vector3& preferred,
                                    const AdviseOptions& options, double horizon_s,
                                    Desk& desk) const {
    const Vector3 velocity =
        options.method == AdviseMethod::kOrca
            ? desk.known.orca(agents_, bee, near_, preferred, horizon_s, options.step_s)
            : avoidance::KnownMethod::mvp(agents_, bee, near_, preferred, horizon_s,
                                          options.step_s);
    const bool as_preferred = velocity == agents_[bee].able(preferred);
    return {velocity_of(velocity),
            as_preferred ? AdviceKind::kAsPreferred : AdviceKind::kDeflected};
  }

  // Collects all conflicts that the threads have found.
  void collect(const ConstraintBuilder& constraint_builder, const AdviseOptions& options,
               Advised& advised) const {
    const auto append = [](const auto& found, auto& all) {
      all.insert(all.end(), found.begin(), found.end());
    };
    for (const Desk& desk : desks_) {
      append(desk.findings.too_close, advised.too_close);
      append(desk.findings.near_obstacle, advised.near_obstacle);
      append(desk.findings.near_fence, advised.near_fence);
      append(desk.findings.near_unknown, advised.near_unknown);
    }
    std::sort(advised.too_close.begin(), advised.too_close.end(),
              [](const TooClose& a, const TooClose& b) { return a.pair < b.pair; });
    for (TooClose& close : advised.too_close) {
      close.clear_s = time_to_clear(close.pair, options, advised);
    }
    keep_nearest_pieces(advised.near_obstacle);
    std::sort(advised.near_fence.begin(), advised.near_fence.end(),
              [](const NearFence& a, const NearFence& b) {
                return std::tie(a.agent, a.fence) < std::tie(b.agent, b.fence);
              });
    std::sort(advised.near_unknown.begin(), advised.near_unknown.end(),
              [](const NearUnknown& a, const NearUnknown& b) {
                return std::tie(a.agent, a.unknown) < std::tie(b.agent, b.unknown);
              });
    for (std::size_t bee = 0; bee < agents_.size(); ++bee) {
      finish(static_cast<PointId>(bee), constraint_builder, options, advised);
    }
  }

  // What depends on the advised velocity.
  void finish(PointId bee, const ConstraintBuilder& constraint_builder,
              const AdviseOptions& options, Advised& advised) const {
    collect_intruders(bee, constraint_builder, options, advised);
    Advice& advice = advised.advice[bee];
    advice.certified = advice.keeps_apart && advice.clear_of_intruders && advice.clear_of_unknown;
  }

  [[nodiscard]] avoidance::AdvisedFlight as_advised(PointId bee, const Advised& advised) const {
    return {agents_[bee], advised.advice[bee].velocity};
  }

  [[nodiscard]] double time_to_clear(const Pair& pair, const AdviseOptions& options,
                                     const Advised& advised) const {
    const auto meeting = avoidance::AdvisedFlight::meeting(
        as_advised(pair.first, advised), as_advised(pair.second, advised), agents_.asked_m(pair),
        options.step_s, std::numeric_limits<double>::infinity());
    return meeting ? meeting->ends_s : 0.0;
  }

  void collect_intruders(PointId bee, const ConstraintBuilder& constraint_builder,
                         const AdviseOptions& options, Advised& advised) const {
    const avoidance::AdvisedFlight flight = as_advised(bee, advised);
    for (std::size_t k = 0; k < options.intruders.size(); ++k) {
      if (!constraint_builder.may_come_close(bee, k)) continue;
      const auto meeting = avoidance::AdvisedFlight::meeting(
          flight, avoidance::AdvisedFlight(options.intruders[k]),
          agents_.apart_from(0.0, bee).asked_m + constraint_builder.intruder_margin_m(k),
          options.step_s, options.intruder_horizon_s);
      if (!meeting) continue;
      advised.advice[bee].clear_of_intruders = false;
      advised.intruder_conflicts.push_back({bee, k, meeting->begins_s, meeting->closest_m});
    }
  }

  avoidance::OneInRound one_;
  avoidance::Intake intake_;
  AgentStates agents_;
  avoidance::Vicinity near_;
  std::vector<char> too_close_;  // of each bee, whether it is so to any
  core::KeptCrew crew_;
  std::vector<Desk> desks_;  // of each worker
};

Adviser::Adviser() : state_(std::make_unique<State>(nullptr)) {
}
Adviser::Adviser(Crew& crew) : state_(std::make_unique<State>(&crew)) {
}
Adviser::Adviser(Adviser&&) noexcept = default;
Adviser& Adviser::operator=(Adviser&&) noexcept = default;
Adviser::~Adviser() = default;

Status Adviser::advise(const MoversView& movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options,
                       Advised& advised) {
  return state_->advise(movers, preferred, limits, options, advised);
}

Status Adviser::advise_one(const AgentInRound& agent, std::span<const AgentInRound> others,
                           const AdviseOptions& options, Advice& advice) {
  return state_->advise_one(agent, others, options, advice);
}

Result<Advised> advise(const MoversView& movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options) {
  Advised advised;
  Status status = Adviser().advise(movers, preferred, limits, options, advised);
  if (!status) return std::move(status).error();
  return advised;
}

}  // namespace beespace
