#include "c_io/coverage.hpp"

#include "analysis/recorded/gaps.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c_io/door.hpp"
#include "c_io/recording.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Status;
using beespace::c::invalid;
namespace analysis = beespace::analysis;

namespace beespace::c_io {

namespace {

std::int64_t number(std::uint64_t count) {
  return static_cast<std::int64_t>(count);
}

// As far as the sentence about it needs it.
analysis::Coverage in_words_of_analysis(const beespace_io_coverage& given) {
  const auto count = [](std::int64_t n) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(n, 0));
  };
  analysis::Coverage coverage;
  coverage.gaps = count(given.gaps);
  coverage.bees_with_gaps = count(given.agents_with_gaps);
  coverage.in_gaps_s = given.in_gaps_s;
  coverage.bees_partly = count(given.agents_partly);
  coverage.bees_cut_off = count(given.agents_cut_off);
  coverage.bees_unplaced = count(given.agents_unplaced);
  coverage.unseen.resize(count(given.agents_on_ground));
  coverage.alone.resize(count(given.agents_alone));
  coverage.alone_is_known = false;
  coverage.missing.count = count(given.missing);
  coverage.missing.nowhere = count(given.nowhere);
  coverage.missing.shared = count(given.shared_ids);
  coverage.missing.files = count(given.files);
  coverage.missing.jumping = count(given.jumping);
  coverage.missing.swapped = count(given.swapped);
  coverage.missing.untimed = count(given.untimed);
  coverage.missing.rough = count(given.rough);
  return coverage;
}

}  // namespace

beespace_io_coverage as_struct(const analysis::Coverage& coverage) {
  const io::MissingRecords& missing = coverage.missing;
  beespace_io_coverage into{};
  into.complete = coverage.complete() ? 1 : 0;
  into.may_hide = coverage.may_hide_conflicts() ? 1 : 0;
  into.max_gap_s = coverage.max_gap.seconds;
  into.typical_interval_s =
      coverage.max_gap.typical_s.value_or(std::numeric_limits<double>::quiet_NaN());
  into.gaps = number(coverage.gaps);
  into.agents_with_gaps = number(coverage.bees_with_gaps);
  into.in_gaps_s = coverage.in_gaps_s;
  into.agents_partly = number(coverage.bees_partly);
  into.agents_cut_off = number(coverage.bees_cut_off);
  into.outside_s = coverage.outside_s;
  into.missing = number(missing.count);
  into.missing_without_id = number(missing.without_id);
  into.missing_agents = number(missing.bees);
  into.nowhere = number(missing.nowhere);
  into.shared_ids = number(missing.shared);
  into.files = number(missing.files);
  into.jumping = number(missing.jumping);
  into.swapped = number(missing.swapped);
  into.untimed = number(missing.untimed);
  into.rough = number(missing.rough + coverage.coarse);
  into.agents_unplaced = number(coverage.bees_unplaced);
  into.agents_on_ground = number(coverage.unseen.size());
  into.agents_alone = number(coverage.compared_with_none() ? coverage.alone.size() : 0);
  return into;
}

std::vector<Gap> gaps_of(const io::Recording& recording, double max_gap_s) {
  std::vector<Gap> gaps;
  for (std::size_t bee = 0; bee < recording.bees.size(); ++bee) {
    const std::vector<Fix>& fixes = recording.bees[bee].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      if (fixes[i].time_s - fixes[i - 1].time_s <= max_gap_s) continue;
      gaps.push_back({static_cast<PointId>(bee), fixes[i - 1].time_s, fixes[i].time_s});
    }
  }
  return gaps;
}

}  // namespace beespace::c_io

extern "C" {

beespace_code beespace_io_recording_coverage(const beespace_io_recording* recording,
                                             double max_gap_s, beespace_io_coverage* coverage,
                                             beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the recording is NULL", "recording");
    if (!(max_gap_s >= 0.0)) {
      return invalid("this is below zero; 0 lets the recording say what a gap is", "max_gap_s");
    }
    const analysis::MaxGap max_gap = analysis::max_gap_of(
        recording->loaded, max_gap_s > 0.0 ? std::optional<double>(max_gap_s) : std::nullopt);
    return beespace::c::write_struct(
        coverage,
        as_struct(analysis::coverage_of(recording->loaded,
                                        gaps_of(recording->loaded, max_gap.seconds), max_gap)),
        "coverage");
  });
}

size_t beespace_io_coverage_text(const beespace_io_coverage* coverage, char* text, size_t size) {
  try {
    std::string line;
    if (coverage != nullptr && beespace::c::size_of_struct(coverage) >= sizeof *coverage) {
      line = analysis::unknown_text(in_words_of_analysis(*coverage));
    }
    if (text != nullptr && size > 0) {
      const std::size_t length = std::min(line.size(), size - 1);
      *std::copy_n(line.data(), length, text) = '\0';
    }
    return line.size();
  } catch (...) {  // out of memory
    if (text != nullptr && size > 0) *text = '\0';
    return 0;
  }
}

}  // extern "C"
