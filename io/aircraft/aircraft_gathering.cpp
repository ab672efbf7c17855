#include "io/aircraft/aircraft_gathering.hpp"

#include "io/problems/unplaced.hpp"

#include <cmath>
#include <utility>

namespace beespace::io {

std::optional<Error> AircraftGathering::begin(std::string description, Unit height_unit,
                                              double repeat_s, bool tells_speeds) {
  if (auto error = aircraft_problem(assembly_.options(), description)) return error;
  SourceFacts facts;
  facts.frame = Frame::kWgs84;
  facts.frame_reason = "aircraft tell longitude and latitude";
  facts.since_1970 = true;
  facts.of_aircraft = true;
  facts.heights = choice_.datum();
  facts.height_unit = height_unit;
  facts.units = AircraftChoice::units(height_unit, description);
  if (!tells_speeds) facts.units.resize(1);
  facts.description = std::move(description);
  if (auto error = assembly_.agree(facts)) return error;
  assembly_.tracks().round_times(repeat_s);
  assembly_.note(choice_.note());
  return std::nullopt;
}

std::optional<Error> AircraftGathering::add(const AircraftReport& report, std::uint64_t line) {
  LeftOut left_out;
  const auto chosen = choice_.choose(report, left_out);
  if (!chosen) return chosen.error();
  const std::string_view id = assembly_.name_of_address(report.id);
  if (!chosen.value()) {
    const Fix place = choice_.place_of(report);
    const bool placed = std::isfinite(place.time_s + place.position.x + place.position.y);
    for (const LeftOutReason& reason : left_out.reasons()) {
      if (placed && reason.which == kOnGround.which) {
        assembly_.claims_ground(id, place);
      } else {
        assembly_.leave_out(reason, id);
      }
    }
    return std::nullopt;
  }
  Origin origin;
  origin.source = assembly_.source() & 0xFF'FFFFu;
  origin.line = line & 0xFF'FFFF'FFFFu;
  const AircraftFix& fix = **chosen;
  assembly_.flies_at(id, fix.fix);
  if (fix.doubts_standing) assembly_.doubt_standing();
  std::optional<double> stated;
  if (report.height_unit != Unit::kMetre) stated = fix.stated_height;
  assembly_.tracks().add(id, fix.fix, &fix.velocity, origin, stated);
  if (!report.label.empty()) assembly_.tracks().label(id, report.label, fix.fix.time_s);
  return std::nullopt;
}

}  // namespace beespace::io
