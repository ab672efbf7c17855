// The answers to all questions about one moment, from the definition and in whole numbers.
#pragma once

#include "tests/contract/answer.hpp"
#include "tests/contract/inquiry.hpp"
#include "tests/differential/whole_numbers.hpp"

#include <beespace/search_options.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace beespace::differential {

using test::Answer;
using test::Question;
using test::Subject;

class SnapshotOracle {
 public:
  // Both must outlive it. The limit of results is not looked at here.
  SnapshotOracle(const Subject& subject, const PairOptions& options);

  Answer answer(Question question, std::uint64_t max_results);

  std::size_t pairs();

 private:
  struct Place {
    Whole x, y, z;
    Whole height;  // what counts in height
  };
  using Rows = std::vector<std::vector<PointId>>;

  [[nodiscard]] std::vector<Place> places_of(const std::vector<Point>& points,
                                             std::span<const double> heights) const;
  // In a straight line; only to be compared with each other.
  [[nodiscard]] Whole squared_line(const Place& p, const Place& q) const;
  [[nodiscard]] bool below(const Whole& value, const Whole& limit) const;
  [[nodiscard]] bool near(const Place& p, const Place& q) const;
  [[nodiscard]] const std::vector<Place>& others() const;
  [[nodiscard]] const std::vector<Point>& other_points() const;
  const Rows& rows();
  [[nodiscard]] Nearest reported(std::size_t i, std::optional<PointId> j) const;

  [[nodiscard]] Answer ids_at_risk();
  [[nodiscard]] std::vector<Pair> all_pairs();
  [[nodiscard]] Answer groups();
  [[nodiscard]] Answer nearest();
  [[nodiscard]] Answer nearest_within();
  [[nodiscard]] Answer closest_pair();
  [[nodiscard]] std::optional<PointId> nearest_to(std::size_t i) const;

  const Subject& subject_;
  const PairOptions& options_;
  bool upright_;  // whether there is a vertical threshold
  bool apart_;    // whether heights are kept apart
  int unit_ = 0;
  Whole threshold_;
  Whole vertical_;
  Whole height_unit_;  // 2^metre_shift_ of these are a metre
  int metre_shift_ = 0;
  std::vector<Place> ours_;
  std::vector<Place> theirs_;
  std::vector<PointId> by_x_;  // the others in the order of x
  std::optional<Rows> rows_;
};

}  // namespace beespace::differential
