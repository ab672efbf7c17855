// The median of many numbers, of which some fit into memory.
#pragma once

#include "out_of_core/sorted_rows.hpp"

#include <beespace/crew.hpp>
#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::out_of_core {

class IntervalMedian {
 public:
  IntervalMedian(std::string folder, std::size_t most_in_memory, Crew& crew)
      : folder_(std::move(folder)), most_(most_in_memory), crew_(crew) {}

  // Errors: kWriteFailed.
  Status add(double number) {
    if (numbers_.size() < most_) {
      numbers_.push_back(number);
      return std::monostate{};
    }
    if (!rest_) {
      const std::size_t bytes = most_ * sizeof(double);
      rest_.emplace(folder_, SortMemory{bytes, bytes});
      for (const double known : numbers_) rest_->add(known);
      if (auto status = rest_->flush(crew_); !status) return status;
    }
    rest_->add(number);
    return rest_->full() ? rest_->flush(crew_) : Status(std::monostate{});
  }

  // Of an even number the lower one of the two in the middle; 0 of none. Then there are none again.
  // Errors: those of SortedRows.
  Result<double> take() {
    double median = 0.0;
    if (rest_) {
      if (auto status = rest_->settle(crew_); !status) return std::move(status).error();
      std::uint64_t left = (rest_->size() - 1) / 2;
      auto status = rest_->for_each([&](double number) {
        median = number;
        return left-- > 0;
      });
      if (!status) return std::move(status).error();
      rest_.reset();
    } else if (!numbers_.empty()) {
      const auto middle = numbers_.begin() + static_cast<std::ptrdiff_t>((numbers_.size() - 1) / 2);
      std::nth_element(numbers_.begin(), middle, numbers_.end());
      median = *middle;
    }
    numbers_.clear();
    return median;
  }

 private:
  std::string folder_;
  std::size_t most_;
  Crew& crew_;
  std::vector<double> numbers_;
  std::optional<SortedRows<double>> rest_;
};

}  // namespace beespace::out_of_core
