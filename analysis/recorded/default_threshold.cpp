#include "analysis/recorded/default_threshold.hpp"

#include <string>
#include <utility>

namespace beespace::analysis {

DefaultThreshold default_threshold(const io::Recording& recording, double otherwise_m) {
  if (recording.declared_threshold_m) {
    return {*recording.declared_threshold_m, ", as the input declares"};
  }
  if (recording.show) {
    return {kDefaultShowThreshold_m, ", the default of shows that declare none (--threshold)"};
  }
  return {otherwise_m, {}};
}

std::optional<Error> threshold_needed(const io::Recording& recording, bool knows_usual) {
  const bool by_pressure = recording.heights == io::HeightDatum::kPressure;
  const bool in_feet =
      recording.height_unit == io::Unit::kFoot || recording.height_unit == io::Unit::kFlightLevel;
  const bool of_aircraft =
      recording.frame == io::Frame::kWgs84 && !recording.show && (by_pressure || in_feet);
  if (!of_aircraft || recording.declared_threshold_m) return std::nullopt;
  std::string message = "these are aircraft, by heights ";
  message += in_feet ? "in feet" : "of pressure";
  message += ": how close is too close? Say ";
  message += knows_usual ? "--separation enroute, --separation terminal, or how far it is, as in "
                           "--threshold 5NM --vertical 1000ft"
                         : "how far it is, as in --threshold 5NM";
  return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
}

}  // namespace beespace::analysis
