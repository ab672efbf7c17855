#include "io/recording/stale_places.hpp"

#include <cmath>

namespace beespace::io {

bool StalePlaces::take(const Fix& fix, const Velocity* velocity) {
  const bool moves = velocity != nullptr && std::hypot(velocity->x, velocity->y) > kMoves_mps;
  const bool stays = moves_ && since_.position.x == fix.position.x &&
                     since_.position.y == fix.position.y && since_.time_s <= fix.time_s;
  moves_ = moves;
  if (!stays) since_ = fix;
  return moves && fix.time_s - since_.time_s > kUsual_s;
}

}  // namespace beespace::io
