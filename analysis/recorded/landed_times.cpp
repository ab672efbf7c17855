#include "analysis/recorded/landed_times.hpp"

#include <beespace/track.hpp>

#include <algorithm>

namespace beespace::analysis {
namespace {

bool stands_during(const io::RecordedBee& bee, double begins_s, double ends_s) {
  return std::any_of(bee.landed.begin(), bee.landed.end(), [&](const TimeSpan& span) {
    return span.begins_s <= begins_s && ends_s <= span.ends_s;
  });
}

}  // namespace

bool has_landed(const io::Recording& recording, PointId track, double time_s) {
  return track < recording.bees.size() && stands_during(recording.bees[track], time_s, time_s);
}

std::size_t leave_out_standing(const io::Recording& recording, std::vector<Conflict>& conflicts) {
  return std::erase_if(conflicts, [&](const Conflict& conflict) {
    return stands_during(recording.bees[conflict.first], conflict.begins_s, conflict.ends_s) &&
           stands_during(recording.bees[conflict.second], conflict.begins_s, conflict.ends_s);
  });
}

}  // namespace beespace::analysis
