// Recordings, searched in every way, against the oracle.
#include "tests/contract/backward_crew.hpp"
#include "tests/differential/described.hpp"
#include "tests/differential/examiner.hpp"
#include "tests/differential/recording_oracle.hpp"
#include "tests/differential/recording_scenes.hpp"
#include "tests/differential/shrink.hpp"

#include "base/memory.hpp"
#include "motion/recorded/recording_search.hpp"
#include "motion/track_segments.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/find_conflicts.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <utility>

namespace beespace::differential {

namespace {

struct Way {
  std::string name;
  std::function<Result<RecordedConflicts>(const std::vector<Track>&, const ConflictOptions&)>
      search;
};

Way with_threads(unsigned threads) {
  return {"functions with " + std::to_string(threads) + " threads",
          [threads](const std::vector<Track>& tracks, ConflictOptions options) {
            options.threads = threads;
            return find_conflicts(tracks, options);
          }};
}

double lasts(const std::vector<Track>& tracks) {
  double first = 0.0;
  double last = 0.0;
  bool any = false;
  for (const Track& track : tracks) {
    for (const Fix& fix : track.fixes) {
      first = any ? std::min(first, fix.time_s) : fix.time_s;
      last = any ? std::max(last, fix.time_s) : fix.time_s;
      any = true;
    }
  }
  return last - first;
}

Way forced(cpu::InstructionSet set, unsigned workers, double share) {
  struct Tools {
    explicit Tools(unsigned workers) : crew(workers) {}
    test::BackwardCrew crew;
    core::Memory memory;
    core::Resources with{crew, memory};
  };
  const auto tools = std::make_shared<Tools>(workers);
  return {
      std::string("forced ") + cpu::name_of(set),
      [=](const std::vector<Track>& tracks,
          const ConflictOptions& options) -> Result<RecordedConflicts> {
        motion::TrackSegments cut = motion::cut_at_gaps(tracks, options.max_gap_s);
        const bool apart = std::any_of(tracks.begin(), tracks.end(),
                                       [](const Track& track) { return !track.heights_m.empty(); });
        motion::RecordingTuning choices;
        choices.search.instruction_set = set;
        choices.step_s = lasts(tracks) * share;
        auto found = motion::search_recording(cut.segments, motion::separation_of(options, apart),
                                              options.max_results, tools->with, choices);
        if (!found) return std::move(found).error();
        return RecordedConflicts{*std::move(found), std::move(cut.gaps)};
      }};
}

std::vector<Way> all_ways() {
  std::vector<Way> ways = {
      {"brute force",
       [](const std::vector<Track>& tracks, const ConflictOptions& options) {
         return brute_force::find_conflicts(tracks, options);
       }},
      with_threads(1),
      with_threads(3),
  };
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    ways.push_back(forced(set, 1, 0.13));
    ways.push_back(forced(set, 3, 0.7));
  }
  return ways;
}

std::vector<Gap> gaps_of(const std::vector<Track>& tracks, double max_gap_s) {
  std::vector<Gap> gaps;
  for (std::size_t id = 0; id < tracks.size(); ++id) {
    const auto& fixes = tracks[id].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      if (fixes[i].time_s - fixes[i - 1].time_s <= max_gap_s) continue;
      gaps.push_back({static_cast<PointId>(id), fixes[i - 1].time_s, fixes[i].time_s});
    }
  }
  return gaps;
}

std::string shown(const Conflict& c) {
  char text[160];
  std::snprintf(text, sizeof text, "%u-%u from %a to %a s, closest at %a s, %a m", c.first,
                c.second, c.begins_s, c.ends_s, c.closest_s, c.closest_m);
  return text;
}

// The error in a variant's answer; empty if there is none.
std::string fault_of(const Way& way, const RecordingScene& scene) {
  const auto& tracks = scene.tracks;
  const auto found = way.search(tracks, scene.options);
  if (!found) return to_string(found.error());
  if (found->gaps != gaps_of(tracks, scene.options.max_gap_s)) return "other gaps";
  auto next = found->conflicts.begin();
  for (PointId i = 0; i < tracks.size(); ++i) {
    for (PointId j = i + 1; j < tracks.size(); ++j) {
      const PairOracle oracle(tracks[i], tracks[j], scene.options);
      for (const Stretch& stretch : oracle.stretches()) {
        if (next == found->conflicts.end() || next->first != i || next->second != j) {
          return "a conflict of " + std::to_string(i) + "-" + std::to_string(j) + " is missing";
        }
        const std::string fault = oracle.fault_of(*next, stretch);
        if (!fault.empty()) return fault + ": " + shown(*next);
        ++next;
      }
      if (next != found->conflicts.end() && next->first == i && next->second == j) {
        return "one too many: " + shown(*next);
      }
    }
  }
  return next == found->conflicts.end() ? "" : "one too many: " + shown(*next);
}

std::string fault_of_closest(const RecordingScene& scene) {
  std::optional<double> least;
  double slack = 0.0;
  for (std::size_t i = 0; i < scene.tracks.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.tracks.size(); ++j) {
      const PairOracle oracle(scene.tracks[i], scene.tracks[j], scene.options);
      slack = std::max(slack, oracle.slack_m());
      const auto closest = oracle.closest_m();
      if (closest) least = std::min(least.value_or(*closest), *closest);
    }
  }
  const auto found = find_closest_encounter(scene.tracks, scene.options.max_gap_s);
  if (!found) return to_string(found.error());
  if (found->has_value() != least.has_value()) return "a closest encounter, or none";
  if (!least) return "";
  if (std::abs((*found)->closest_m - *least) <= slack) return "";
  return "the closest is " + hex(*least) + " m: " + shown(**found);
}

template <class Fault>
std::string least_of(const std::string& name, RecordingScene scene, Fault&& fault) {
  scene.tracks = shrunk(scene.tracks, [&](const std::vector<Track>& tracks) {
    RecordingScene less = scene;
    less.tracks = tracks;
    return !fault(less).empty();
  });
  return name + ", " + text_of(scene) + "  " + fault(scene) + "\n";
}

std::optional<std::string> examine(const std::vector<Way>& ways, Random& random, Tally& tally) {
  tally.scene();
  const RecordingScene scene = random_recording(random);
  const std::string kind = scene.options.vertical_m ? ", vertical" : "";
  const auto ask = [&](const Way& way) -> std::optional<std::string> {
    tally.answer("recorded conflicts" + kind);
    const auto fault = [&](const RecordingScene& one) { return fault_of(way, one); };
    if (fault(scene).empty()) return std::nullopt;
    return least_of(way.name, scene, fault);
  };
  for (const std::size_t plain : {0U, 1U}) {
    if (auto found = ask(ways[plain])) return found;
  }
  for (int i = 0; i < 2; ++i) {
    if (auto found = ask(random.one_of(ways))) return found;
  }
  if (scene.options.vertical_m) return std::nullopt;  // it knows spheres only
  tally.answer("closest encounter");
  if (fault_of_closest(scene).empty()) return std::nullopt;
  return least_of("find_closest_encounter", scene, fault_of_closest);
}

}  // namespace

Examiner recording_examiner() {
  const auto ways = std::make_shared<std::vector<Way>>(all_ways());
  return {"recordings",
          [ways](Random& random, Tally& tally) { return examine(*ways, random, tally); }};
}

}  // namespace beespace::differential
