// Whether the answers that are about to be timed are right.
#pragma once

#include "cli/bench/bench_question.hpp"

#include <cstddef>
#include <string>

namespace beespace::cli {

inline constexpr std::size_t kBeesChecked = 50;

// Compares what the answers say of some bees with brute force over all others, and where there are
// pairs all groups with what follows from these. Empty when everything agrees, otherwise what does
// not: "pairs of bee 17".
std::string disagreement(const std::vector<Point>& points, const BenchScene& scene,
                         const BenchAnswers& answers);

}  // namespace beespace::cli
