// Coasts and borders, which the page without data holds: they stay in it where bees lie over so
// wide a part of the Earth that these tell where it is, and are left out of all others.
#pragma once

#include "report/facts.hpp"

#include <string_view>
#include <utility>

namespace beespace::report {

enum class Ground { kWithout, kWith };

// By how far apart the places to look at are.
Ground ground_of(const SnapshotFacts& facts);
Ground ground_of(const RecordingFacts& facts);

// What of the page stands before the ground, and after it; with no ground in it, all and nothing.
std::pair<std::string_view, std::string_view> around_ground(std::string_view page);

}  // namespace beespace::report
