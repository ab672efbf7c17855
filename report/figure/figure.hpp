// One picture of what was seen: from above, from the side, a chart, and the worst in words.
//
// Who is too close was decided by the engine; a picture adds nothing to that. It is the same for
// the same facts. Swarms of any size are drawn in a time that grows with the bees, into a drawing
// that does not.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/facts.hpp"

namespace beespace::report {

Drawing figure_of(const SnapshotFacts& facts);
Drawing figure_of(const RecordingFacts& facts);

}  // namespace beespace::report
