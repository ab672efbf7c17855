// An answer to any of the questions, and its difference from the reference answer.
#pragma once

#include "bench/compare/question.hpp"

#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace beespace::compare {

// The container of the given question is filled, the others stay empty. Pairs have
// first < second, in any order; ids ascend; counts and nearest have an entry a point.
struct Answer {
  std::vector<PointId> at_risk;
  std::vector<Pair> pairs;
  std::vector<Nearest> nearest;
  std::vector<std::uint32_t> counts;
};

// How many things were found: points at risk, pairs, points with a nearest other, neighbours.
std::uint64_t size_of(const Answer& answer, Question question);

// The ids whose mark is set, ascending.
std::vector<PointId> ids_of_marks(const std::vector<char>& marks);

struct Difference {
  std::uint64_t spurious = 0;  // in the answer, not in the reference (counts, nearest: differing)
  std::uint64_t missed = 0;    // in the reference, not in the answer
};

// Keeps a right answer in a file, or compares with the one kept there. Answers of more than
// kMostPairsKept pairs are kept as a number and a fingerprint: then a difference is known by the
// numbers alone, or by 1 and 1 when only the fingerprints differ.
//
// Sorts the pairs of `answer`. A nearest other is right when its true distance is the right one
// within 1e-12: which of several equally near points is named is free. Both end the process with a
// message when the file cannot be written or read.
inline constexpr std::uint64_t kMostPairsKept = 60'000'000;
void keep_reference(const std::string& path, Question question, Answer& answer);
Difference difference_from_reference(const std::string& path, Question question,
                                     std::span<const Point> points, Answer& answer);

// Of two ascending lists.
Difference difference(const std::vector<PointId>& found, const std::vector<PointId>& expected);

}  // namespace beespace::compare
