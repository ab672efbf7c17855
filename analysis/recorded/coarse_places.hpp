// Places that are written with so few decimals that whether two were too close cannot be told, and
// whole seconds in which bees go farther than the threshold.
//
// Places are rounded where those of a bee are all multiples of a power of ten, on a way that no
// even motion explains: what is planned or computed on a lattice goes evenly, and small whole
// numbers of metres are left to it. In degrees a bee whose place never changes is taken to have as
// many decimals as the others: what is measured wavers. The difference of two rounded places is off
// by one step along each axis at most, whichever way they were rounded. Heights are not looked at.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/verify_paths.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/stated_accuracy.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

class PlaceSteps {
 public:
  // Fixes in the order of time, as the input gives them.
  void take(const Fix& fix);

  // How many decimals its places have, as an index that is greater the more these are.
  [[nodiscard]] std::size_t decimals() const;
  [[nodiscard]] bool moves() const { return moves_; }
  // How far apart two neighbouring places are at most that can be written; 0 where nothing shows
  // that places are rounded. `most_decimals` is the greatest of all bees.
  [[nodiscard]] double coarse_m(io::Frame frame, std::size_t most_decimals) const;

 private:
  struct Axis {
    std::size_t decimals = 0;
    double step = 0.0;  // from the last fix but one to the last one
  };
  // Whether the step bends the way, by more than half of what can be written.
  bool take_axis(Axis& axis, double before, double now, double stretch);

  std::size_t fixes_ = 0;
  std::size_t bends_ = 0;
  std::size_t triples_ = 0;  // about evenly apart in time
  Fix last_ = {};
  double last_s_ = 0.0;  // how long the step to it took
  double reach_ = 0.0;   // the greatest coordinate
  bool moves_ = false;
  std::array<Axis, 2> axes_ = {};
};

// What was found, as far as it matters here.
struct CoarseQuestion {
  double threshold_m;
  bool conflicts;  // there are some: that is no all-clear in any case
  // Of all encounters; nothing where there is none, which leaves nothing to tell.
  std::optional<double> closest_m;
  // Whether places that never change count: not where the closest two were not looked for, as round
  // ones of two who stand far apart hide nothing.
  bool unmoved = true;
};

// Of a search. With a vertical threshold distances in space tell nothing: any two may be that
// close.
CoarseQuestion coarse_question(const ConflictOptions& options,
                               const std::vector<Conflict>& conflicts,
                               const std::optional<Conflict>& closest);

CoarseQuestion coarse_question(const PathVerdict& verdict, const PathQuestion& question);

// `steps` of each bee.
void judge_places(const std::vector<PlaceSteps>& steps, io::Frame frame,
                  const CoarseQuestion& question, Coverage& coverage);
// The same of places that are written finely, but are that far off by the table itself: half of
// them, of each bee, or more.
void judge_accuracy(const io::StatedAccuracy& accuracy, const CoarseQuestion& question,
                    Coverage& coverage);
// Both of a recording with all its fixes, and of its times.
void judge_places(const io::Recording& recording, const CoarseQuestion& question,
                  Coverage& coverage);

}  // namespace beespace::analysis
