// Of each bee of a recording that comes some fixes at a time, the ones at its beginning and its
// end: where it appears and vanishes, and how it moves then (see coverage.hpp).
#pragma once

#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace beespace::analysis {

class TrackEnds {
 public:
  // In any order. A second fix at the time of another one is not kept.
  void add(std::size_t bee, const Fix& fix);

  // The first two and the last two, in order of time; fewer of a bee that has no more.
  [[nodiscard]] std::vector<Fix> of(std::size_t bee) const;

 private:
  struct Ends {
    std::array<Fix, 2> first;  // the earliest first
    std::array<Fix, 2> last;   // the latest first
    std::size_t count = 0;     // of each, that there are
  };
  std::vector<Ends> ends_;
};

}  // namespace beespace::analysis
