#include "analysis/scene/height_words.hpp"

namespace beespace::analysis {

report::HeightWords height_words(io::Unit unit, io::HeightDatum datum) {
  return {unit == io::Unit::kFoot || unit == io::Unit::kFlightLevel,
          datum == io::HeightDatum::kPressure, datum == io::HeightDatum::kMeanSeaLevel};
}

bool speaks_of_feet(const report::HeightWords& heights,
                    const std::optional<io::StatedLength>& vertical) {
  return heights.in_feet || (vertical && (vertical->unit == io::Unit::kFoot ||
                                          vertical->unit == io::Unit::kFlightLevel));
}

}  // namespace beespace::analysis
