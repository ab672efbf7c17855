#include "analysis/scene/height_words.hpp"

namespace beespace::analysis {

report::HeightWords height_words(io::Unit unit, io::HeightDatum datum) {
  return {unit == io::Unit::kFoot || unit == io::Unit::kFlightLevel,
          datum == io::HeightDatum::kPressure, datum == io::HeightDatum::kMeanSeaLevel,
          datum == io::HeightDatum::kUnstated || datum == io::HeightDatum::kHome,
          datum == io::HeightDatum::kHome};
}

bool speaks_of_feet(const report::HeightWords& heights, io::Unit threshold,
                    const std::optional<io::StatedLength>& vertical) {
  const auto is_of_aviation = [](io::Unit unit) {
    return unit == io::Unit::kNauticalMile || unit == io::Unit::kFoot ||
           unit == io::Unit::kFlightLevel;
  };
  return heights.in_feet || is_of_aviation(threshold) ||
         (vertical && is_of_aviation(vertical->unit));
}

}  // namespace beespace::analysis
