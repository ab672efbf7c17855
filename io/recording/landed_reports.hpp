// Which places of a drone are on the ground, by what its autopilot says beside them now and then:
// that it has landed, or not. Where it does not say so surely, it is taken for flying.
//
// A place is on the ground where the report before it and the one behind it both say so, and these
// are no more than 5 s apart; of a log that holds each change, where the last report before it
// does. Up to 5 s before the first report and behind the last one it is as these say where it is
// the same place, within a metre. Who says at a place to be faster than a drone on the ground
// flies.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::io {

class LandedReports {
 public:
  struct Place {
    std::int64_t micros = 0;  // by the clock of the reports
    Point position = {};
    Velocity velocity = {};  // not-a-number where unknown
  };

  // In the order in which they came.
  void take(std::int64_t micros, bool landed);
  // Each change is among them.
  void hold_all_changes() { all_changes_ = true; }
  // Whether it has ever said so.
  [[nodiscard]] bool any_landed() const;

  // One for each of the places, which are in the order in which they came.
  [[nodiscard]] std::vector<bool> on_ground(const std::vector<Place>& places, Frame frame) const;

 private:
  struct Report {
    std::int64_t micros;
    bool landed;
  };

  [[nodiscard]] bool says_landed(std::int64_t micros) const;
  void add_before_first(const std::vector<Place>& places, Frame frame,
                        std::vector<bool>& ground) const;
  void add_behind_last(const std::vector<Place>& places, Frame frame,
                       std::vector<bool>& ground) const;

  std::vector<Report> reports_;
  bool all_changes_ = false;
  bool goes_back_ = false;  // the clock does: then nothing is sure
};

}  // namespace beespace::io
