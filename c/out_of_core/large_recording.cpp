// Recordings beyond memory: how fixes come there, and the conflicts that are shown to visitors.
#include <beespace/recording_out_of_core.hpp>

#include "c/door/options.hpp"
#include "c/door/points.hpp"
#include "c/door/question.hpp"
#include "c/door/structs.hpp"
#include "c/motion/fixes.hpp"
#include "c/out_of_core/audience.hpp"
#include "c/out_of_core/out_of_core.hpp"

#include <beespace/points_view.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::AgentId;
using beespace::ConflictOptions;
using beespace::LargeConflict;
using beespace::LargeGap;
using beespace::OutOfCoreOptions;
using beespace::PointsView;
using beespace::RecordingOutOfCore;
using beespace::RecordingOutOfCoreFacts;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_large_recording {
  RecordingOutOfCore recording;
  double height_unit_m;
};

namespace {

// Ids of C have a sign: in their order, without one.
constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
AgentId agent_of(std::int64_t id) {
  return static_cast<AgentId>(id) ^ kSign;
}
std::int64_t id_of(AgentId agent) {
  return static_cast<std::int64_t>(agent ^ kSign);
}

Status add_fixes(beespace_large_recording& to, const beespace_fixes* fixes,
                 const beespace_points* positions) {
  const Result<PointsView> places = view_of(positions, "positions");
  if (!places) return places.error();
  const std::size_t size = places->size();
  const Result<FixColumns> columns = columns_of(fixes, size);
  if (!columns) return columns.error();
  if (columns->climbs_mps) {
    return invalid("climb rates are for live swarms: the heights of a recording say how it climbs",
                   "climbs");
  }
  if (columns->height_unit_m != 0.0 && columns->height_unit_m != to.height_unit_m) {
    return invalid("the unit of heights is that of the options: leave it 0 here", "heights");
  }
  std::vector<AgentId> agents(size);
  std::vector<double> times_s(size);
  std::vector<double> heights_m(columns->heights_m ? size : 0);
  for (std::size_t row = 0; row < size; ++row) {
    agents[row] = agent_of(columns->agents[row]);
    times_s[row] = columns->times_s[row];
    if (columns->heights_m) heights_m[row] = (*columns->heights_m)[row];
  }
  return to.recording.add(agents, times_s,
                          heights_m.empty() ? *places : places->with_heights(heights_m));
}

// Conflicts in columns.
class ConflictColumns {
 public:
  int show(std::span<const LargeConflict> conflicts, beespace_conflicts_visitor visit, void* data) {
    first_.clear();
    second_.clear();
    for (auto& column : numbers_) column.clear();
    for (const LargeConflict& conflict : conflicts) {
      first_.push_back(id_of(conflict.first));
      second_.push_back(id_of(conflict.second));
      numbers_[0].push_back(conflict.begins_s);
      numbers_[1].push_back(conflict.closest_s);
      numbers_[2].push_back(conflict.ends_s);
      numbers_[3].push_back(conflict.closest_m);
    }
    return visit(data, first_.data(), second_.data(), numbers_[0].data(), numbers_[1].data(),
                 numbers_[2].data(), numbers_[3].data(),
                 static_cast<std::int64_t>(conflicts.size()));
  }
  int show(std::span<const LargeGap> gaps, beespace_gaps_visitor visit, void* data) {
    first_.clear();
    for (auto& column : numbers_) column.clear();
    for (const LargeGap& gap : gaps) {
      first_.push_back(id_of(gap.agent));
      numbers_[0].push_back(gap.begins_s);
      numbers_[1].push_back(gap.ends_s);
    }
    return visit(data, first_.data(), numbers_[0].data(), numbers_[1].data(),
                 static_cast<std::int64_t>(gaps.size()));
  }

 private:
  std::vector<std::int64_t> first_;
  std::vector<std::int64_t> second_;
  std::vector<double> numbers_[4];
};

Result<ConflictOptions> conflict_options_of(const beespace_search* search, double max_gap_s,
                                            double height_unit_m) {
  const Result<Search> asked = search_of(search, kWithin | BEESPACE_MAX_RESULTS);
  if (!asked) return asked.error();
  ConflictOptions options;
  options.threshold_m = asked->options.threshold_m;
  options.vertical_m = asked->options.vertical_m;
  options.inclusive = asked->options.inclusive;
  options.max_gap_s = max_gap_s;
  options.max_results = asked->options.max_results;
  options.height_unit_m = height_unit_m;
  return options;
}

}  // namespace

extern "C" {

beespace_code beespace_large_recording_create(const beespace_out_of_core_options* options,
                                              beespace_large_recording** recording,
                                              beespace_error* error) {
  if (recording != nullptr) *recording = nullptr;
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    const Result<beespace_out_of_core_options> given = read_struct(options, "options");
    if (!given) return given.error();
    const Result<OutOfCoreOptions> wanted = options_of(*given);
    if (!wanted) return wanted.error();
    const double unit_m = given->height_unit_m == 0.0 ? 1.0 : given->height_unit_m;
    *recording = std::make_unique<beespace_large_recording>(
                     beespace_large_recording{RecordingOutOfCore(*wanted), unit_m})
                     .release();
    return std::monostate{};
  });
}

void beespace_large_recording_free(beespace_large_recording* recording) {
  delete recording;
}

int64_t beespace_large_recording_size(const beespace_large_recording* recording) {
  return recording == nullptr ? 0 : static_cast<int64_t>(recording->recording.size());
}

beespace_code beespace_large_recording_add(beespace_large_recording* recording,
                                           const beespace_fixes* fixes,
                                           const beespace_points* positions,
                                           beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    return add_fixes(*recording, fixes, positions);
  });
}

beespace_code beespace_large_recording_conflicts(beespace_large_recording* recording,
                                                 const beespace_search* search, double max_gap_s,
                                                 const beespace_run* run,
                                                 beespace_conflicts_visitor conflicts,
                                                 beespace_gaps_visitor gaps, void* data,
                                                 beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    if (conflicts == nullptr) return invalid("the pointer to the visitor is NULL", "conflicts");
    if (gaps == nullptr && max_gap_s <= beespace::kLargestInMotion) {
      return invalid("gaps are unknown, and must be seen: give a visitor", "gaps");
    }
    return call_watched(run, [&](const RunOptions& options) -> Status {
      const Result<ConflictOptions> asked =
          conflict_options_of(search, max_gap_s, recording->height_unit_m);
      if (!asked) return asked.error();
      Audience audience(options);
      ConflictColumns columns;
      recording->recording.set_run(audience.run());
      return audience.status_of(recording->recording.find_conflicts(
          *asked,
          [&](std::span<const LargeConflict> some) {
            audience.tell([&] { return columns.show(some, conflicts, data); });
          },
          [&](std::span<const LargeGap> some) {
            if (gaps != nullptr) audience.tell([&] { return columns.show(some, gaps, data); });
          }));
    });
  });
}

beespace_code beespace_large_recording_facts_of(const beespace_large_recording* recording,
                                                beespace_large_recording_facts* facts,
                                                beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    const RecordingOutOfCoreFacts known = recording->recording.facts();
    beespace_large_recording_facts told{};
    told.windows = static_cast<std::int64_t>(known.windows);
    told.copies = static_cast<std::int64_t>(known.copies);
    told.largest_window = static_cast<std::int64_t>(known.largest_window);
    told.encounters = known.encounters ? 1 : 0;
    return write_struct(facts, told, "facts");
  });
}

}  // extern "C"
