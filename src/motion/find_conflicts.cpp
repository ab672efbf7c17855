#include <beespace/brute_force.hpp>
#include <beespace/find_conflicts.hpp>

#include "core/validate.hpp"
#include "cpu/crew_size.hpp"
#include "motion/pair_walk.hpp"
#include "motion/recording_search.hpp"
#include "motion/runs.hpp"
#include "motion/validate.hpp"

#include <utility>

namespace beespace {

namespace {

std::optional<Error> check(std::span<const Track> tracks, const ConflictOptions& options) {
  if (auto error = motion::check_options(options)) return error;
  if (auto error = core::check_size(tracks.size())) return error;
  return motion::check_tracks(tracks);
}

}  // namespace

Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                         const ConflictOptions& options) {
  if (auto error = check(tracks, options)) return *std::move(error);
  motion::Runs cut = motion::cut_at_gaps(tracks, options.max_gap_s);
  ThreadCrew crew(cpu::crew_size(options.threads, cut.runs.size()));
  core::Memory memory;
  memory.start_call();
  auto conflicts = motion::search_recording(cut.runs, motion::separation_of(options),
                                            options.max_results, {crew, memory});
  if (!conflicts) return std::move(conflicts).error();
  return RecordedConflicts{*std::move(conflicts), std::move(cut.gaps)};
}

namespace brute_force {

Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                         const ConflictOptions& options) {
  if (auto error = check(tracks, options)) return *std::move(error);
  motion::Runs cut = motion::cut_at_gaps(tracks, options.max_gap_s);
  const motion::Separation separation = motion::separation_of(options);
  constexpr double kEver = std::numeric_limits<double>::infinity();
  RecordedConflicts answer;
  for (std::size_t i = 0; i < cut.runs.size(); ++i) {
    for (std::size_t j = i + 1; j < cut.runs.size(); ++j) {
      if (cut.runs[i].track == cut.runs[j].track) continue;
      motion::PairWalk::State state;
      motion::PairWalk(cut.runs[i], cut.runs[j], separation)
          .walk({-kEver, kEver}, state, answer.conflicts);
      if (answer.conflicts.size() > options.max_results) {
        return core::too_many_results(options.max_results);
      }
    }
  }
  motion::order_conflicts(answer.conflicts);
  answer.gaps = std::move(cut.gaps);
  return answer;
}

}  // namespace brute_force

}  // namespace beespace
