// Positions that may not be in metres, as the threshold shows.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/points/loaded_points.hpp"
#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/point.hpp>

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::analysis {

// How far it is across all places, from the least to the greatest coordinates.
class Spread {
 public:
  void add(const Point& place);
  [[nodiscard]] double metres() const;  // infinite of none

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Point least_{kFar, kFar, kFar};
  Point greatest_{-kFar, -kFar, -kFar};
};

// Whether there is anything to doubt if they are spread far: whether the threshold is that small,
// and nothing names the unit.
bool may_be_pixels(const std::vector<io::UnitTaken>& units, io::Frame frame,
                   const std::optional<io::StatedLength>& threshold);

// A threshold in millimetres or less beside places, whose unit nothing names, that are spread so
// much farther: pixels of a picture, perhaps, of which none would come close. Errors:
// kInvalidArgument, with what to type; `if_pixels` is what to do then.
inline constexpr std::string_view kWithScale = "say how long one is, as in --scale 0.1mm";
inline constexpr std::string_view kWithoutScale = "make lengths of them first";
std::optional<Error> doubt_of_scale(const io::Recording& recording,
                                    const std::optional<io::StatedLength>& threshold);
std::optional<Error> doubt_of_scale(const io::LoadedPoints& points,
                                    const std::optional<io::StatedLength>& threshold);
std::optional<Error> doubt_of_scale(const std::vector<io::UnitTaken>& units, io::Frame frame,
                                    const Spread& spread,
                                    const std::optional<io::StatedLength>& threshold,
                                    std::string_view if_pixels);

}  // namespace beespace::analysis
