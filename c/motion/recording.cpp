// Recordings: what moved when, and what came too close.
#include <beespace/find_conflicts.hpp>

#include "c/door/options.hpp"
#include "c/door/question.hpp"
#include "c/motion/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Conflict;
using beespace::ConflictOptions;
using beespace::RecordedConflicts;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

namespace {

Result<ConflictOptions> conflict_options_of(const beespace_search* search, double max_gap_s,
                                            const RunOptions& run) {
  const Result<Search> asked = search_of(search, kWithin | BEESPACE_MAX_RESULTS);
  if (!asked) return asked.error();
  ConflictOptions options;
  options.threshold_m = asked->options.threshold_m;
  options.vertical_m = asked->options.vertical_m;
  options.inclusive = asked->options.inclusive;
  options.max_gap_s = max_gap_s;
  options.threads = run.threads;
  options.max_results = asked->options.max_results;
  options.stop = run.stop;
  return options;
}

// C++ counts tracks; the caller has ids of agents.
void name_agents(const Agents& agents, beespace_result& result) {
  for (auto* const ids : {&result.first, &result.second, &result.gap_agents}) {
    for (std::size_t i = 0; i < ids->size(); ++i) {
      (*ids)[i] = agents.ids[static_cast<std::size_t>((*ids)[i])];
    }
  }
}

// Asks ask(recording, run options), which writes into the result; tracks are named afterwards.
template <class Ask>
beespace_code answer_of_recording(const beespace_recording* recording, const beespace_run* run,
                                  beespace_result* result, beespace_error* error, Ask&& ask) {
  return answer_into(result, error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    return call_watched(run, [&](const RunOptions& options) -> Status {
      Status status = ask(recording->agents, options);
      if (status) name_agents(recording->agents, *result);
      return status;
    });
  });
}

}  // namespace

extern "C" {

beespace_code beespace_recording_create(const beespace_fixes* fixes,
                                        const beespace_points* positions, const beespace_run* run,
                                        beespace_recording** recording, beespace_error* error) {
  if (recording != nullptr) *recording = nullptr;
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    std::unique_ptr<beespace_recording> made;
    Status status = call_watched(run, [&](const RunOptions& options) -> Status {
      Result<Agents> agents = agents_of(fixes, positions, options.stop);
      if (!agents) return std::move(agents).error();
      made = std::make_unique<beespace_recording>(beespace_recording{*std::move(agents)});
      return std::monostate{};
    });
    if (status) *recording = made.release();
    return status;
  });
}

void beespace_recording_free(beespace_recording* recording) {
  delete recording;
}

int64_t beespace_recording_agents(const beespace_recording* recording) {
  return recording == nullptr ? 0 : static_cast<int64_t>(recording->agents.ids.size());
}

beespace_code beespace_recording_conflicts(const beespace_recording* recording,
                                           const beespace_search* search, double max_gap_s,
                                           const beespace_run* run, beespace_result* result,
                                           beespace_error* error) {
  const auto ask = [&](const Agents& agents, const RunOptions& run_options) -> Status {
    Result<ConflictOptions> options = conflict_options_of(search, max_gap_s, run_options);
    if (!options) return options.error();
    options->height_unit_m = agents.height_unit_m;
    const Result<RecordedConflicts> found = beespace::find_conflicts(agents.tracks, *options);
    if (!found) return found.error();
    write_gaps(found->gaps, *result);
    return write_conflicts(found->conflicts, run_options.stop, *result);
  };
  return answer_of_recording(recording, run, result, error, ask);
}

beespace_code beespace_recording_closest(const beespace_recording* recording, double max_gap_s,
                                         const beespace_run* run, beespace_result* result,
                                         beespace_error* error) {
  const auto ask = [&](const Agents& agents, const RunOptions& options) -> Status {
    if (agents.heights_apart) {
      return invalid(
          "the recording has heights apart from its positions, and the closest is asked "
          "of positions in space: make one without heights",
          "recording");
    }
    const Result<std::optional<Conflict>> closest =
        beespace::find_closest_encounter(agents.tracks, max_gap_s, options);
    if (!closest) return closest.error();
    write_gaps(gaps_of(agents, max_gap_s), *result);
    if (!*closest) return std::monostate{};
    return write_conflicts(std::array{**closest}, options.stop, *result);
  };
  return answer_of_recording(recording, run, result, error, ask);
}

}  // extern "C"
