#include "cli/watch/no_places.hpp"

namespace beespace::cli {

std::optional<std::string> NoPlaces::zero(const io::ReportLine& at) {
  if (at.frame != io::Frame::kWgs84) return std::nullopt;
  zeros_.look_at(at.position);
  if (!zeros_.is_none(at.position)) return std::nullopt;
  return "is " + std::string(io::kZeroPlace.which);
}

std::optional<std::string> NoPlaces::stale(AgentId bee, double time_s, const io::ReportLine& at) {
  if (bee >= stale_.size()) stale_.resize(bee + 1);
  if (!stale_[bee].take({time_s, at.position}, &at.stated_velocity)) return std::nullopt;
  return "says the same place as for more than 3 s before, though its speed is more than 3 m/s, as "
         "where the last place is said again once contact is lost,";
}

void NoPlaces::forget(AgentId bee) {
  if (bee < stale_.size()) stale_[bee] = {};
}

}  // namespace beespace::cli
