#include "analysis/recorded/shared_ids.hpp"

#include <algorithm>

namespace beespace::analysis {

bool is_of_shared_id(const Conflict& conflict, const io::Recording& recording) {
  return recording.bees[conflict.first].shared || recording.bees[conflict.second].shared;
}

void doubt_shared_ids(const io::Recording& recording, std::vector<Conflict>& conflicts) {
  if (recording.missing.shared == 0) return;
  for (Conflict& conflict : conflicts) {
    if (is_of_shared_id(conflict, recording)) conflict.certain = false;
  }
}

std::size_t count_of_shared_ids(const std::vector<Conflict>& conflicts,
                                const io::Recording& recording) {
  if (recording.missing.shared == 0) return 0;
  return static_cast<std::size_t>(std::count_if(
      conflicts.begin(), conflicts.end(),
      [&recording](const Conflict& conflict) { return is_of_shared_id(conflict, recording); }));
}

}  // namespace beespace::analysis
