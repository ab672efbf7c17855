// Answers put together from one query a point, as most libraries are used.
#pragma once

#include "bench/compare/answer.hpp"
#include "bench/compare/question.hpp"

#include <beespace/point.hpp>

#include <cstdint>
#include <vector>

namespace beespace::compare {

// Queries `index` for each point of `order`, which names every point once. An index has
//   bool has_other(PointId self)                    whether another point is within the threshold
//   void visit_near(PointId self, Visit&& visit)    calls visit(id) for each such point (`self` may
//                                                   be one of them)
//   std::uint32_t count_others(PointId self)        how many others are within the threshold
//   Nearest nearest_other(PointId self)
template <class Index>
Answer answer_point_by_point(Question question, const std::vector<PointId>& order, Index&& index) {
  Answer answer;
  switch (question) {
    case Question::kAtRisk: {
      std::vector<char> marks(order.size());
      for (const PointId self : order) marks[self] = index.has_other(self);
      answer.at_risk = ids_of_marks(marks);
      break;
    }
    case Question::kPairs:
      for (const PointId self : order) {
        index.visit_near(self, [&](PointId other) {
          if (other > self) answer.pairs.push_back({self, other});
        });
      }
      break;
    case Question::kNearest:
      answer.nearest.resize(order.size());
      for (const PointId self : order) answer.nearest[self] = index.nearest_other(self);
      break;
    case Question::kCounts:
      answer.counts.resize(order.size());
      for (const PointId self : order) answer.counts[self] = index.count_others(self);
      break;
  }
  return answer;
}

}  // namespace beespace::compare
