// When the receivers of satellites of a drone had no fix any more, none of them: what its filter
// then tells of its place on the Earth is a guess, also where it does not say so. One that never
// had a fix may know its place otherwise, as by motion capture.
#pragma once

#include <cstdint>
#include <vector>

namespace beespace::io {

class SatelliteFixes {
 public:
  // Of receivers by number, in any order.
  void take(std::uint8_t receiver, std::uint64_t micros, bool has_fix);
  // Once all is taken.
  void settle();
  [[nodiscard]] bool lost_at(std::uint64_t micros) const;

 private:
  struct Report {
    std::uint64_t micros;
    std::uint8_t receiver;
    bool has_fix;
  };
  // From then on.
  struct Change {
    std::uint64_t micros;
    bool lost;
  };

  std::vector<Report> reports_ = {};
  std::vector<Change> changes_ = {};
};

}  // namespace beespace::io
