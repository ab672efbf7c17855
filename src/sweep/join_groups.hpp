// Joins near points into groups by sweeping a whole grid with all threads.
#pragma once

#include "base/disjoint_sets.hpp"
#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

namespace beespace::cpu {

// Joins the sorted places of every two near points of a swarm by itself. Working memory: 4 bytes a
// point.
void join_near(const SweepQuery& question, const core::Resources& with, core::DisjointSets& groups);

}  // namespace beespace::cpu
