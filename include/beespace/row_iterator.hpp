/// @file
/// @brief Iterates over the rows of IdRows and NearestRows.
#pragma once

#include <compare>
#include <cstddef>
#include <iterator>
#include <utility>

namespace beespace {

/// @brief A random-access iterator over rows, each of which is a span.
///
/// Ownership: refers to the rows, which must outlive it. The spans refer to the memory of the rows,
/// not to the iterator.
template <class Rows>
class RowIterator {
 public:
  /// @brief Of the ranges of C++20: elements are reached in any order.
  using iterator_concept = std::random_access_iterator_tag;
  /// @brief Of the algorithms before C++20: elements are values, not references.
  using iterator_category = std::input_iterator_tag;
  /// @brief A row: a span.
  using value_type = decltype(std::declval<const Rows&>()[0]);
  /// @brief A row: a span, by value.
  using reference = value_type;
  /// @brief The difference of two iterators.
  using difference_type = std::ptrdiff_t;

  /// @brief Refers to no rows; only for assignment.
  constexpr RowIterator() = default;
  /// @brief Refers to one row.
  /// @param rows The rows; must outlive this.
  /// @param row The index of the row; the number of rows for the end.
  constexpr RowIterator(const Rows& rows, std::size_t row)
      : rows_(&rows), row_(static_cast<std::ptrdiff_t>(row)) {}

  /// @brief Gives the row.
  /// @return A span in the memory of the rows.
  [[nodiscard]] value_type operator*() const { return (*this)[0]; }
  /// @brief Gives the row some rows further on.
  /// @param rows How many rows further on; may be negative.
  /// @return A span in the memory of the rows.
  [[nodiscard]] value_type operator[](difference_type rows) const {
    return (*rows_)[static_cast<std::size_t>(row_ + rows)];
  }

  /// @cond iterator
  RowIterator& operator++() { return *this += 1; }
  RowIterator& operator--() { return *this -= 1; }
  RowIterator operator++(int) { return std::exchange(*this, *this + 1); }
  RowIterator operator--(int) { return std::exchange(*this, *this - 1); }
  RowIterator& operator+=(difference_type rows) {
    row_ += rows;
    return *this;
  }
  RowIterator& operator-=(difference_type rows) { return *this += -rows; }

  friend RowIterator operator+(RowIterator at, difference_type rows) { return at += rows; }
  friend RowIterator operator+(difference_type rows, RowIterator at) { return at += rows; }
  friend RowIterator operator-(RowIterator at, difference_type rows) { return at -= rows; }
  friend difference_type operator-(const RowIterator& a, const RowIterator& b) {
    return a.row_ - b.row_;
  }
  friend bool operator==(const RowIterator& a, const RowIterator& b) { return a.row_ == b.row_; }
  friend auto operator<=>(const RowIterator& a, const RowIterator& b) { return a.row_ <=> b.row_; }
  /// @endcond

 private:
  const Rows* rows_ = nullptr;
  std::ptrdiff_t row_ = 0;
};

}  // namespace beespace
