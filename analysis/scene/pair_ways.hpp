// The ways between those who come too close, around their conflicts.
#pragma once

#include "analysis/scene/uprights.hpp"
#include "report/facts.hpp"

#include <beespace/conflict.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// How far apart they are when they are closest.
std::optional<report::Apart> apart_in(const Conflict& conflict, const Uprights& uprights);

// Of the first of `conflicts`, as many as a page can hold.
std::vector<report::PairWay> pair_ways(const std::vector<Conflict>& conflicts,
                                       const Uprights& uprights);

}  // namespace beespace::analysis
