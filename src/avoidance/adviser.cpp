#include <beespace/advise.hpp>
#include <beespace/crew.hpp>
#include <beespace/engine.hpp>

#include "avoidance/certificate.hpp"
#include "avoidance/disposal.hpp"
#include "avoidance/validate.hpp"
#include "cpu/crew_size.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace beespace {

namespace {

using avoidance::Flyer;
using avoidance::HalfSpace;
using avoidance::Parting;
using avoidance::Segment;
using avoidance::Vector3;

// What rounding may take from a distance along the way: the threshold is widened by it, and a pair
// is certified while at least half of it is left.
double spare_of(double threshold_m, double farthest_m) {
  return 1e-7 * threshold_m + 0x1p-44 * farthest_m;
}

// Of its greatest speed: how fast somebody makes room.
constexpr double kAside = 0.5;

// Speeds that are no more than rounding are none: nobody is told to leave the motion domain.
double told(double component_mps) {
  return std::abs(component_mps) < 0x1p-80 ? 0.0 : component_mps;
}

}  // namespace

class __attribute__((visibility("hidden"))) Adviser::State {
 public:
  Status advise(const MoversView& movers, std::span<const Velocity> preferred,
                std::span<const FlightLimits> limits, const AdviseOptions& options,
                Advised& advised) {
    if (auto error = avoidance::check(movers, preferred, limits, options)) {
      return *std::move(error);
    }
    take(movers, limits, options);
    wishes_ = preferred;
    const SearchOptions around{.threshold_m = farthest_apart(), .threads = options.threads};
    if (Status found = engine_.find_neighbors(movers.positions(), around, near_); !found) {
      return found;
    }
    advised.advice.assign(movers.size(), {});
    ThreadCrew& crew = crew_for(options.threads, movers.size());
    crew.split(movers.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
      Desk& desk = desks_[worker];
      desk.too_close.clear();
      for (std::size_t bee = begin; bee < end; ++bee) {
        const auto id = static_cast<PointId>(bee);
        advised.advice[bee] = advise_one(id, desk);
      }
    });
    advised.too_close.clear();
    for (const Desk& desk : desks_) {
      advised.too_close.insert(advised.too_close.end(), desk.too_close.begin(),
                               desk.too_close.end());
    }
    return std::monostate{};
  }

 private:
  void take(const MoversView& movers, std::span<const FlightLimits> limits,
            const AdviseOptions& options) {
    flyers_.clear();
    stops_.clear();
    farthest_reach_m_ = 0.0;
    double farthest_m = 0.0;
    for (std::size_t i = 0; i < movers.size(); ++i) {
      const auto [p, v] = movers[i];
      const FlightLimits& limit = limits[limits.size() == 1 ? 0 : i];
      const Flyer& flyer = flyers_.emplace_back(Flyer{avoidance::vector_of(p),
                                                      avoidance::vector_of(v),
                                                      {limit, options.step_s},
                                                      limit.max_speed_mps});
      const Stop& stop = stops_.emplace_back(Stop{flyer.way_to_stop(), flyer.reach()});
      farthest_reach_m_ = std::max(farthest_reach_m_, stop.reach_m);
      farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    const double apart_m = options.threshold_m + 2.0 * options.uncertainty_m;
    const double spare_m = spare_of(apart_m, farthest_m + farthest_reach_m_);
    kept_m_ = apart_m + spare_m;
    certified_m_ = apart_m + 0.5 * spare_m;
  }

  // Who is farther apart cannot meet, whatever both do.
  [[nodiscard]] double farthest_apart() const {
    return (kept_m_ + 2.0 * farthest_reach_m_) * (1.0 + 0x1p-40);
  }

  // The way of a bee to its stop as it flies now, and how far it may get in a step and its stop.
  struct Stop {
    Segment way;
    double reach_m;
  };

  // What one worker works with.
  struct Desk {
    std::vector<HalfSpace> keep_to;
    avoidance::Disposal disposal;
    std::vector<Pair> too_close;
  };

  ThreadCrew& crew_for(unsigned threads, std::size_t bees) {
    const unsigned size = cpu::crew_size(threads, bees);
    if (!crew_ || crew_->size() != size) crew_.emplace(size);
    desks_.resize(crew_->size());
    return *crew_;
  }

  [[nodiscard]] Advice advise_one(PointId bee, Desk& desk) const {
    const Flyer& flyer = flyers_[bee];
    const auto& [way, reach_m] = stops_[bee];
    desk.keep_to.clear();
    Vector3 pressed;
    bool certified = true;
    for (const PointId other : near_[bee]) {
      const auto& [other_way, other_reach_m] = stops_[other];
      const double meet_m = (kept_m_ + reach_m + other_reach_m) * (1.0 + 0x1p-40);
      const Vector3 between = way.from - other_way.from;
      if (dot(between, between) > meet_m * meet_m) continue;
      const bool is_first = bee < other;
      const Parting parting =
          is_first ? part(way, other_way, kept_m_) : part(other_way, way, kept_m_);
      desk.keep_to.push_back(is_first ? parting.of_first(kept_m_) : parting.of_second(kept_m_));
      pressed = pressed + pressure(other, desk.keep_to.back().normal, parting.gap);
      if (parting.gap >= certified_m_) continue;
      certified = false;
      if (is_first) desk.too_close.push_back({bee, other});
    }
    const Vector3 wish = avoidance::vector_of(wishes_[bee]);
    const bool makes_room = is_idle(bee) && !(pressed == Vector3{});
    const Vector3 aside = at_most(pressed, 1.0) * (kAside * flyer.max_speed);
    const auto [v, kind] =
        desk.disposal.dispose(flyer, makes_room ? wish + aside : wish, desk.keep_to);
    const bool as_wished = kind == AdviceKind::kAsWished && makes_room;
    return {
        {told(v.x), told(v.y), told(v.z)}, as_wished ? AdviceKind::kDeflected : kind, certified};
  }

  // Whoever is where it wants to be makes room for those who are close and want through: how much
  // another one presses a bee that lies from it in the direction `away`, across a gap.
  [[nodiscard]] Vector3 pressure(PointId other, const Vector3& away, double gap_m) const {
    constexpr double kClose = 0.6;  // of the threshold, beyond it
    const double free = (gap_m - kept_m_) / (kClose * kept_m_);
    if (free >= 1.0 || is_idle(other) || dot(avoidance::vector_of(wishes_[other]), away) <= 0.0) {
      return {};
    }
    return away * (1.0 - free);
  }

  [[nodiscard]] bool is_idle(PointId bee) const {
    constexpr double kIdle = 0.3;  // of what it can fly
    return length(avoidance::vector_of(wishes_[bee])) < kIdle * flyers_[bee].max_speed;
  }

  Engine engine_;
  IdRows near_;
  std::span<const Velocity> wishes_;  // of this call
  std::vector<Flyer> flyers_;
  std::vector<Stop> stops_;  // of each
  double farthest_reach_m_ = 0.0;
  double kept_m_ = 0.0;       // how far apart everybody stays
  double certified_m_ = 0.0;  // who is closer than this has lost what rounding was allowed
  std::optional<ThreadCrew> crew_;
  std::vector<Desk> desks_;  // of each worker
};

Adviser::Adviser() : state_(std::make_unique<State>()) {
}
Adviser::Adviser(Adviser&&) noexcept = default;
Adviser& Adviser::operator=(Adviser&&) noexcept = default;
Adviser::~Adviser() = default;

Status Adviser::advise(const MoversView& movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options,
                       Advised& advised) {
  return state_->advise(movers, preferred, limits, options, advised);
}

Result<Advised> advise(const MoversView& movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options) {
  Advised advised;
  Status status = Adviser().advise(movers, preferred, limits, options, advised);
  if (!status) return std::move(status).error();
  return advised;
}

}  // namespace beespace
