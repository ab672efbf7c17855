#include "sim/channel.hpp"

#include <algorithm>

namespace beespace::sim {

// A chain of two states, good and bad, which is bad for a share `loss` of the time.
bool Losses::loses(std::size_t sender) {
  if (!(errors_.loss > 0.0)) return false;
  if (sender >= in_a_row_.size()) in_a_row_.resize(sender + 1, 0);
  int& run = in_a_row_[sender];
  const double stays = std::max(errors_.loss, errors_.in_a_row);
  const double begins = std::min(1.0, errors_.loss * (1.0 - stays) / (1.0 - errors_.loss));
  const bool lost = random_.uniform() < (run > 0 ? stays : begins) && run < errors_.longest_run;
  run = lost ? run + 1 : 0;
  return lost;
}

}  // namespace beespace::sim
