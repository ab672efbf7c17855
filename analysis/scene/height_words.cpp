#include "analysis/scene/height_words.hpp"

namespace beespace::analysis {

report::HeightWords height_words(io::Unit unit, io::HeightDatum datum) {
  return {unit == io::Unit::kFoot || unit == io::Unit::kFlightLevel,
          datum == io::HeightDatum::kPressure, datum == io::HeightDatum::kMeanSeaLevel};
}

}  // namespace beespace::analysis
