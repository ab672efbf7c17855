#include "tests/differential/examiner.hpp"

namespace beespace::differential {

std::vector<Examiner> all_examiners() {
  return {snapshot_examiner("spheres", false),
          snapshot_examiner("cylinders", true),
          index_examiner(),
          prediction_examiner(),
          recording_examiner(),
          swarm_examiner()};
}

}  // namespace beespace::differential
