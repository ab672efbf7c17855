// Positions that may not be in metres, as the threshold shows.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/points/loaded_points.hpp"
#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::analysis {

// How far it is across all places, from the least to the greatest coordinates.
class Spread {
 public:
  void add(const Point& place);
  [[nodiscard]] double metres() const;  // infinite of none
  [[nodiscard]] const Point& least() const { return least_; }
  [[nodiscard]] const Point& greatest() const { return greatest_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Point least_{kFar, kFar, kFar};
  Point greatest_{-kFar, -kFar, -kFar};
};

// Places whose unit nothing names, and that are whole numbers throughout: over a thousand wide,
// beside a threshold of a few, they are millimetres rather than metres, of which whole ones would
// not do for it.
class WholePlaces {
 public:
  void add(const Point& place);
  // Errors: kInvalidArgument, with what to type.
  [[nodiscard]] std::optional<Error> doubt(const std::optional<io::StatedLength>& threshold) const;

 private:
  Spread spread_ = {};
  std::size_t places_ = 0;
  bool whole_ = true;
};

bool are_without_unit(const std::vector<io::UnitTaken>& units, io::Frame frame);

// Whether there is anything to doubt: whether the threshold is in a unit that small, and nothing
// names that of the places.
bool may_be_pixels(const std::vector<io::UnitTaken>& units, io::Frame frame,
                   const std::optional<io::StatedLength>& threshold);

// What the summary says where a caller's word alone makes metres of such places; empty elsewhere.
std::string metres_note(const std::vector<io::UnitTaken>& units, io::Frame frame,
                        const std::optional<io::StatedLength>& threshold);

// Faster than that, places whose unit nothing names are hardly in metres: what is watched for such
// a threshold does not cross it many times a second, but for what flies wide ways.
double fastest_in_metres(const std::optional<io::StatedLength>& threshold);

struct PlacesTaken {
  const std::vector<io::UnitTaken>& units;
  io::Frame frame;
  bool asked_for_metres;  // by --crs metres
};

// A threshold in centimetres or less beside places whose unit nothing names: millimetres or pixels
// of a picture, perhaps, of which none would come close. Who says metres is believed, unless they
// are spread so much farther. Of recordings also places that would move too fast in metres. Errors:
// kInvalidArgument, with what to type; `asked` is the frame that the caller
// asked for, `if_pixels` what to do then.
inline constexpr std::string_view kWithScale = "say how long one is, as in --scale 0.1mm";
inline constexpr std::string_view kWithoutScale = "make lengths of them first";
std::optional<Error> doubt_of_scale(const io::Recording& recording, io::Frame asked,
                                    const std::optional<io::StatedLength>& threshold);
std::optional<Error> doubt_of_scale(const io::LoadedPoints& points, io::Frame asked,
                                    const std::optional<io::StatedLength>& threshold);
std::optional<Error> doubt_of_scale(const PlacesTaken& taken, const Spread& spread,
                                    const std::optional<io::StatedLength>& threshold,
                                    std::string_view if_pixels);

// The same before it is known how far they are spread.
std::optional<Error> doubt_of_unit(const PlacesTaken& taken,
                                   const std::optional<io::StatedLength>& threshold);

}  // namespace beespace::analysis
