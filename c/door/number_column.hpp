// The caller's numbers, one for each of something, with all checks that pointers allow.
#pragma once

#include "c/door/structs.hpp"

#include <cstddef>
#include <limits>

namespace beespace::c {

// Of any stride; 0 repeats one.
template <class Number>
class NumberColumn {
 public:
  NumberColumn(const Number* first, std::ptrdiff_t stride) : first_(first), stride_(stride) {}
  // One after the other.
  explicit NumberColumn(const Number* first)
      : NumberColumn(first, static_cast<std::ptrdiff_t>(sizeof(Number))) {}

  // What is wrong with it, if anything is, where there are `size` numbers, one or more.
  [[nodiscard]] const char* problem(std::size_t size) const {
    if (first_ == nullptr) return "this is NULL, but there must be one for each of the others";
    constexpr auto kAlignment = static_cast<std::ptrdiff_t>(alignof(Number));
    if (!is_aligned(first_) || (size > 1 && stride_ % kAlignment != 0)) {
      return "these are not aligned as their type is: copy them first";
    }
    const std::ptrdiff_t farthest =
        std::numeric_limits<std::ptrdiff_t>::max() / static_cast<std::ptrdiff_t>(size);
    const bool beyond = stride_ > farthest || stride_ < -farthest;
    return size > 1 && beyond ? "a stride is so large that the last one is beyond all memory"
                              : nullptr;
  }
  Number operator[](std::size_t index) const {
    const auto* const bytes = reinterpret_cast<const std::byte*>(first_);
    return *reinterpret_cast<const Number*>(bytes + static_cast<std::ptrdiff_t>(index) * stride_);
  }

 private:
  const Number* first_;
  std::ptrdiff_t stride_;
};

}  // namespace beespace::c
