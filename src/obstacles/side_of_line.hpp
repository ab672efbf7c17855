// On which side of a line is a point? Decided exactly, so that what is built on it (crossings,
// insides, cuts) never contradicts itself.
#pragma once

#include <beespace/obstacle.hpp>

namespace beespace::obstacles {

struct Edge {
  Corner from;
  Corner to;
};

// 1 where `point` lies to the left of the line from `from` to `to`, -1 to the right, 0 on it: the
// sign of the doubled area of the triangle of the three. Exact in the motion domain.
int side_of_line(const Corner& from, const Corner& to, const Corner& point);

}  // namespace beespace::obstacles
