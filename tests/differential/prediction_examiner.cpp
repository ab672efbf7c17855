// Predictions, made in every way, against the oracle.
#include "tests/contract/backward_crew.hpp"
#include "tests/differential/described.hpp"
#include "tests/differential/examiner.hpp"
#include "tests/differential/prediction_scenes.hpp"
#include "tests/differential/shrink.hpp"

#include "base/memory.hpp"
#include "motion/predict/prediction.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/engine.hpp>
#include <beespace/predict_conflicts.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace beespace::differential {

namespace {

using Conflicts = std::vector<Conflict>;

// Flights as the library reads them.
class Movers {
 public:
  Movers(const std::vector<Flight>& flights, bool apart) {
    for (const Flight& f : flights) {
      positions_.push_back(f.mover.position);
      velocities_.push_back({f.mover.velocity.x, f.mover.velocity.y, f.mover.velocity.z});
      if (!apart) continue;
      heights_.push_back(f.height);
      climbs_.push_back(f.climb);
    }
  }
  [[nodiscard]] MoversView view() const {
    if (heights_.empty()) return {positions_, velocities_};
    return {positions_, velocities_, heights_, climbs_};
  }

 private:
  std::vector<Point> positions_;
  std::vector<Point> velocities_;
  std::vector<double> heights_;
  std::vector<double> climbs_;
};

// One way to predict; the pairs are those of the conflicts where it has no others.
struct Way {
  std::string name;
  std::function<Result<Conflicts>(const MoversView&, const PredictOptions&)> conflicts;
  std::function<Result<std::vector<Pair>>(const MoversView&, const PredictOptions&)> pairs;
};

Way with_threads(unsigned threads) {
  const auto with = [threads](PredictOptions options) {
    options.threads = threads;
    return options;
  };
  return {"functions with " + std::to_string(threads) + " threads",
          [with](const MoversView& movers, const PredictOptions& options) {
            return predict_conflicts(movers, with(options));
          },
          [with](const MoversView& movers, const PredictOptions& options) {
            return predict_pairs(movers, with(options));
          }};
}

Way by_brute_force() {
  return {"brute force",
          [](const MoversView& movers, const PredictOptions& options) {
            return brute_force::predict_conflicts(movers, options);
          },
          {}};
}

Way by_engine() {
  const auto engine = std::make_shared<Engine>();
  return {"Engine",
          [engine](const MoversView& movers, const PredictOptions& options) -> Result<Conflicts> {
            Conflicts found;
            const Status status = engine->predict_conflicts(movers, options, found);
            if (!status) return status.error();
            return found;
          },
          [engine](const MoversView& movers,
                   const PredictOptions& options) -> Result<std::vector<Pair>> {
            std::vector<Pair> found;
            const Status status = engine->predict_pairs(movers, options, found);
            if (!status) return status.error();
            return found;
          }};
}

// With steps of a length that is a share of the horizon, or as chosen; with several workers.
Way forced(cpu::InstructionSet set, std::optional<unsigned> row_shift, unsigned workers,
           std::optional<double> share) {
  struct Tools {
    explicit Tools(unsigned workers) : crew(workers) {}
    test::BackwardCrew crew;
    core::Memory memory;
    core::Resources with{crew, memory};
  };
  const auto tools = std::make_shared<Tools>(workers);
  const auto choices = [set, row_shift, share](const PredictOptions& options) {
    motion::PredictionTuning chosen;
    chosen.search.instruction_set = set;
    chosen.search.row_shift = row_shift;
    if (share) chosen.step_s = options.horizon_s * *share;
    return chosen;
  };
  return {
      std::string("forced ") + cpu::name_of(set) + (share ? " in steps" : ""),
      [=](const MoversView& movers, const PredictOptions& options) -> Result<Conflicts> {
        Conflicts found;
        const Status status =
            motion::predict(movers, options, tools->with, found, choices(options));
        if (!status) return status.error();
        return found;
      },
      [=](const MoversView& movers, const PredictOptions& options) -> Result<std::vector<Pair>> {
        std::vector<Pair> found;
        const Status status =
            motion::predict_pairs(movers, options, tools->with, found, choices(options));
        if (!status) return status.error();
        return found;
      }};
}

std::vector<Way> all_ways() {
  std::vector<Way> ways = {by_brute_force(), with_threads(1), with_threads(3), by_engine()};
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    ways.push_back(forced(set, {}, 1, {}));
    ways.push_back(forced(set, 0, 3, 0.3));
    ways.push_back(forced(set, 2, 2, 0.011));
  }
  return ways;
}

std::vector<Pair> pairs_of(const Conflicts& conflicts) {
  std::vector<Pair> pairs;
  for (const Conflict& c : conflicts) pairs.push_back({c.first, c.second});
  return pairs;
}

std::string shown(const std::vector<Pair>& pairs) {
  std::string text;
  for (const Pair& p : pairs) {
    text.append(" ").append(std::to_string(p.first)).append("-").append(std::to_string(p.second));
  }
  return text.empty() ? " none" : text;
}

// The error in a variant's answers about a scene; empty if there is none.
std::string fault_of(const Way& way, const PredictionScene& scene) {
  const Movers movers(scene.flights, scene.apart);
  const std::vector<Pair> expected = pairs_in_conflict(scene.flights, scene.options, scene.apart);
  const auto conflicts = way.conflicts(movers.view(), scene.options);
  if (!conflicts) return "conflicts: " + to_string(conflicts.error());
  if (pairs_of(*conflicts) != expected) {
    return "conflicts: expected" + shown(expected) + ", got" + shown(pairs_of(*conflicts));
  }
  for (const Conflict& c : *conflicts) {
    const std::string fault =
        fault_of(c, scene.flights[c.first], scene.flights[c.second], scene.options, scene.apart);
    if (!fault.empty()) {
      char text[160];
      std::snprintf(text, sizeof text, ": from %a to %a s, closest at %a s, %a m", c.begins_s,
                    c.ends_s, c.closest_s, c.closest_m);
      return "conflict" + shown({{c.first, c.second}}) + ": " + fault + text;
    }
  }
  if (!way.pairs) return "";
  const auto pairs = way.pairs(movers.view(), scene.options);
  if (!pairs) return "pairs: " + to_string(pairs.error());
  if (*pairs != expected) return "pairs: expected" + shown(expected) + ", got" + shown(*pairs);
  return "";
}

std::string text_of(const PredictionScene& scene) {
  const PredictOptions& o = scene.options;
  std::string text = scene.name;
  text.append(": threshold ").append(hex(o.threshold_m));
  if (o.vertical_m) text.append(", vertical ").append(hex(*o.vertical_m));
  text.append(o.inclusive ? ", inclusive" : ", strict");
  text.append(", horizon ").append(hex(o.horizon_s)).append("\n");
  for (const Flight& f : scene.flights) {
    const Velocity& v = f.mover.velocity;
    text.append("    {").append(described(f.mover.position)).append(", ");
    text.append(described(Point{v.x, v.y, v.z})).append("}");
    if (scene.apart)
      text.append(" height ").append(hex(f.height)).append(" climb ").append(hex(f.climb));
    text.append("\n");
  }
  return text;
}

std::optional<std::string> examine(const std::vector<Way>& ways, Random& random, Tally& tally) {
  tally.scene();
  const PredictionScene scene = random_prediction(random);
  const std::string kind = scene.options.vertical_m ? ", vertical" : "";
  const auto ask = [&](const Way& way) -> std::optional<std::string> {
    tally.answer("conflicts" + kind);
    if (way.pairs) tally.answer("pairs" + kind);
    if (fault_of(way, scene).empty()) return std::nullopt;
    PredictionScene least = scene;
    least.flights = shrunk(scene.flights, [&](const std::vector<Flight>& flights) {
      PredictionScene less = scene;
      less.flights = flights;
      return !fault_of(way, less).empty();
    });
    return way.name + ", " + text_of(least) + "  " + fault_of(way, least) + "\n";
  };
  // The plain ones always, of the others some.
  for (const std::size_t plain : {0U, 1U}) {
    if (auto found = ask(ways[plain])) return found;
  }
  for (int i = 0; i < 3; ++i) {
    if (auto found = ask(random.one_of(ways))) return found;
  }
  return std::nullopt;
}

}  // namespace

Examiner prediction_examiner() {
  const auto ways = std::make_shared<std::vector<Way>>(all_ways());
  return {"predictions",
          [ways](Random& random, Tally& tally) { return examine(*ways, random, tally); }};
}

}  // namespace beespace::differential
