#include "analysis/recorded/shared_ids.hpp"

#include <algorithm>
#include <string>

namespace beespace::analysis {

bool is_shared(const io::Recording& recording, PointId bee) {
  const std::vector<std::string>& shared = recording.missing.shared_ids;
  return std::find(shared.begin(), shared.end(), recording.bees[bee].id) != shared.end();
}

bool is_with_shared_id(const io::Recording& recording, const Conflict& conflict) {
  return is_shared(recording, conflict.first) || is_shared(recording, conflict.second);
}

std::size_t count_with_shared_id(const io::Recording& recording,
                                 const std::vector<Conflict>& conflicts) {
  if (recording.missing.shared_ids.empty()) return 0;
  return static_cast<std::size_t>(std::count_if(
      conflicts.begin(), conflicts.end(),
      [&recording](const Conflict& conflict) { return is_with_shared_id(recording, conflict); }));
}

void doubt_with_shared_id(const io::Recording& recording, std::vector<Conflict>& conflicts) {
  if (recording.missing.shared_ids.empty()) return;
  for (Conflict& conflict : conflicts) {
    conflict.certain = conflict.certain && !is_with_shared_id(recording, conflict);
  }
}

}  // namespace beespace::analysis
