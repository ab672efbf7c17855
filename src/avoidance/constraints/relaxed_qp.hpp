// The point that is nearest to a preferred one within hard half-spaces, and within requested ones
// as far as possible: a relaxed quadratic program.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"

#include <optional>
#include <span>
#include <vector>

namespace beespace::avoidance {

// A requested half-space, which may be relaxed by so much at most.
struct Request {
  HalfSpace side;
  double yields = 0.0;
};

class RelaxedQp {
 public:
  // Where not all requests can be met, each drops the part that no point of the ball satisfies (or
  // almost none). Then all are relaxed by the same share of the rest, the least that suffices (to a
  // five-hundredth). Nothing where they cannot be met even then.
  std::optional<Vector3> nearest(const Vector3& target, std::span<const HalfSpace> firm,
                                 std::span<const Request> requests, const Ball& ball);

 private:
  void ask_for_what_there_is(std::span<const Request> requests, const Ball& ball);
  std::optional<Vector3> at(double share, const Vector3& target, std::span<const HalfSpace> firm,
                            const Ball& ball);

  std::vector<Request> requests_;
  std::vector<HalfSpace> all_;
};

}  // namespace beespace::avoidance
