// What becomes of a wish: the nearest velocity that is certified.
//
// Any wish will do, a good one or a bad one; whatever comes out keeps to the half-spaces, except
// that the bee brakes as hard as it can where nothing better is found. Braking keeps to them too.
#pragma once

#include "avoidance/constraints/claims.hpp"
#include "avoidance/constraints/half_spaces.hpp"
#include "avoidance/constraints/soft_program.hpp"
#include "avoidance/flyer.hpp"

#include <beespace/advise.hpp>

#include <vector>

namespace beespace::avoidance {

class Disposal {
 public:
  struct Disposed {
    Vector3 velocity;
    AdviceKind kind;
  };
  Disposed dispose(const Flyer& flyer, const Vector3& wish, const Claims& claims);

 private:
  void put_in_changes(const Flyer& flyer, const Vector3& from, const Claims& claims,
                      double most_change, double within);

  // Of velocity.
  std::vector<HalfSpace> firm_;
  std::vector<Request> requests_;
  SoftProgram program_;
};

}  // namespace beespace::avoidance
