#include "io/mavlink/heard_landings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::io {

void find_landed(const VehicleLandings& landings, Frame frame, std::vector<Heard>& heard) {
  constexpr std::size_t kSystems = 256;
  std::array<std::vector<Heard*>, kSystems> of_systems;
  for (Heard& one : heard) {
    if (one.is_taken && one.at.by != PlaceBy::kOfAnother) of_systems[one.system].push_back(&one);
  }
  for (const std::vector<Heard*>& of_system : of_systems) {
    if (of_system.empty()) continue;
    const Heard& first = *of_system.front();
    const LandedReports* const reports = landings.of(first.system, first.component);
    if (reports == nullptr || !reports->any_landed()) continue;
    std::vector<LandedReports::Place> places;
    places.reserve(of_system.size());
    for (const Heard* const one : of_system) {
      places.push_back({static_cast<std::int64_t>(one->stamp), one->at.position, one->at.velocity,
                        one->at.above_home_m});
    }
    const std::vector<bool> landed = reports->on_ground(places, frame);
    for (std::size_t i = 0; i < of_system.size(); ++i) of_system[i]->landed = landed[i];
  }
}

}  // namespace beespace::io
