// Searches with a vertical threshold by the one method and by the other, whatever suits the points.
#pragma once

#include "tests/contract/variants.hpp"

#include <vector>

namespace beespace::differential {

std::vector<test::Variant> forced_cylinders();

}  // namespace beespace::differential
