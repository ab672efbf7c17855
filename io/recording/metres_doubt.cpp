#include "io/recording/metres_doubt.hpp"

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/recording/unit_doubts.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace beespace::io {

void MetresDoubt::take_step(const Fix& from, const Fix& to) {
  const double metres = flat_distance_m(from.position, to.position, Frame::kMetres);
  const double seconds = to.time_s - from.time_s;
  if (metres > 0.0 && seconds > 0.0) speeds_mps_.push_back(metres / seconds);
}

std::optional<Error> MetresDoubt::doubt() const {
  if (speeds_mps_.empty()) return std::nullopt;
  std::vector<double> speeds = speeds_mps_;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  if (!(*middle > fastest_mps_)) return std::nullopt;
  return too_fast_in_metres(*middle);
}

}  // namespace beespace::io
