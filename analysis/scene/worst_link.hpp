// Where a page shows the worst pair, as what follows its address.
#pragma once

#include "analysis/scene/scene.hpp"

#include <string>

namespace beespace::analysis {

// "#t=12.5&bees=3,17", or without a time for a snapshot, as docs/page-format.md has it; empty where
// no two are too close.
std::string worst_link(const Scene& scene);

}  // namespace beespace::analysis
