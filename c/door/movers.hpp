// The caller's positions and velocities as movers of the C++ library.
#pragma once

#include <beespace.h>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

namespace beespace::c {

// What the arguments of one set of movers are called in errors.
struct MoverNames {
  const char* positions;
  const char* velocities;
};
inline constexpr MoverNames kMovers = {"positions", "velocities"};

Result<MoversView> movers_of(const beespace_points* positions, const beespace_points* velocities,
                             const MoverNames& names);

// C++ says which mover cannot be; C also says which of its two arrays that is about.
Error with_array(Error error, const MoversView& movers, const MoverNames& names);

}  // namespace beespace::c
