#pragma once

// Scenes whose neighbours are those in a cylinder: every variant of every question against integers
// of any size.
#include "tests/contract/answer.hpp"
#include "tests/support/exact_cylinder_oracle.hpp"

#include <beespace/search_options.hpp>

#include <cstddef>
#include <map>
#include <string>

namespace beespace::test {

using Answers = std::map<std::string, Answer>;  // by question

double one_ulp_above(double value);
double one_ulp_below(double value);

Answers by_functions(const CylinderScene& scene, const SearchOptions& options);
void expect_same(const Answers& answers, const Answers& right, const std::string& variant);

// Every variant of every question; returns how many pairs there are.
std::size_t check(const CylinderScene& scene, bool inclusive, const std::string& name);

// The same scene with its thresholds an ulp either side, as it is, with heights apart, and in two
// sets.
std::size_t check_all_forms(const CylinderScene& scene, const std::string& name);

// Heights that were z are given apart, upon positions that lie in no plane.
CylinderScene apart(CylinderScene scene, double unit);
CylinderScene in_two_sets(CylinderScene scene);

}  // namespace beespace::test
