// Aircraft of which nothing new is heard: some feeds, as that of OpenSky, go on to say the last
// place for minutes, at the time at which it was heard. Who is kept so did not leave what is looked
// at: it was lost, and is still there at no known place.
#pragma once

#include "io/recording/recording.hpp"

#include <vector>

namespace beespace::io {

// Sets `unplaced_until_s` of those whose last fix is said again and again: so often as the time
// between two of its records says how long that goes on, but not beyond the last fix of all.
void lose_coasting(std::vector<RecordedBee>& bees);

}  // namespace beespace::io
