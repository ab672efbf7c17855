// Places in metres at 0, 0, 0, or at another number that stands for all coordinates, as -1, -1 or
// -9999, -9999, that a bee could only jump to: robots that do not know yet where they are, and
// trackers that have lost an animal, write them. In degrees see zero_places.hpp.
#pragma once

#include "io/problems/left_out.hpp"

#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kZeroRun = {
    "at 0, 0, 0 exactly, or at one number for all coordinates, as -1, -1 or -999, -999, which is "
    "written where no place is known (the bee would get there more than three times as fast as it "
    "ever moves elsewhere),",
    "the bee was somewhere else then"};

// Which of the fixes of a bee, in the order of time, are such; empty where none is. Of a few fixes
// it is not said.
std::vector<bool> zero_runs(const std::vector<Fix>& fixes);

// The same of fixes that come one after the other, by what came before each. A run with which a bee
// begins is not known as one then: see ZeroRunWatch.
class ZeroRunFilter {
 public:
  bool is_none(const Fix& fix);

 private:
  std::optional<Fix> run_ = {};   // such a place, where the bee would be now
  std::optional<Fix> last_ = {};  // that is none of these
  std::size_t others_ = 0;
  double fastest_mps_ = 0.0;
};

// The same of fixes that come one after the other; those that go back in time count for nothing.
class ZeroRunWatch {
 public:
  // `number`: how the caller knows the fix again.
  void take(const Fix& fix, std::uint64_t number);
  // Once all came: the first fix of such a run; nothing where there is none.
  [[nodiscard]] std::optional<std::uint64_t> found() const;

 private:
  struct Run {
    std::uint64_t first = 0;
    std::size_t fixes = 0;
    std::optional<double> came_mps = {};  // how fast the bee would have got there
  };

  // The run is over; `left_mps`: how fast the bee would have gone on.
  void end(const Run& run, std::optional<double> left_mps);

  std::optional<Fix> last_ = {};
  std::optional<Run> run_ = {};
  std::size_t others_ = 0;         // steps between places that are none of these
  double fastest_mps_ = 0.0;       // of them
  double slowest_jump_mps_ = 0.0;  // of the run whose slower jump is the fastest
  std::uint64_t first_ = 0;        // of that run
};

}  // namespace beespace::io
