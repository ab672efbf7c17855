#include "analysis/recorded/default_threshold.hpp"

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

}  // namespace beespace::analysis
