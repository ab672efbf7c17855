// The place that is nearest to a wish within some half-spaces, and within as much of others as
// there is room for.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"

#include <optional>
#include <span>
#include <vector>

namespace beespace::avoidance {

// Asked for, and given up by so much at most.
struct Request {
  HalfSpace side;
  double yields = 0.0;
};

class RelaxedQp {
 public:
  // Where not all requests can be met, each gives up what no place of the ball has (or all but
  // none), and the same share of what it may then, no more of it than must be (to a
  // five-hundredth). Nothing where they cannot be met at all.
  std::optional<Vector3> nearest(const Vector3& wish, std::span<const HalfSpace> firm,
                                 std::span<const Request> requests, const Ball& ball);

 private:
  void ask_for_what_there_is(std::span<const Request> requests, const Ball& ball);
  std::optional<Vector3> at(double share, const Vector3& wish, std::span<const HalfSpace> firm,
                            const Ball& ball);

  std::vector<Request> requests_;
  std::vector<HalfSpace> all_;
};

}  // namespace beespace::avoidance
