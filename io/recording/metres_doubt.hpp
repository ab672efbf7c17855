// Places that come one after the other, whose unit nothing names: in metres they may be too fast
// for what is watched. Of recordings see doubt_of_metres().
#pragma once

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::io {

class MetresDoubt {
 public:
  explicit MetresDoubt(double fastest_mps) : fastest_mps_(fastest_mps) {}

  // From one report of a bee to its next.
  void take_step(const Fix& from, const Fix& to);
  // Whether enough was heard, and more would tell nothing else.
  [[nodiscard]] bool is_settled() const { return speeds_mps_.size() >= kEnough; }
  // The same of so much that it says something, where no more comes.
  [[nodiscard]] bool tells() const { return speeds_mps_.size() >= kFewest; }
  // Errors: kInvalidArgument, without source.
  [[nodiscard]] std::optional<Error> doubt() const;

 private:
  static constexpr std::size_t kFewest = 8;
  static constexpr std::size_t kEnough =
      64;  // steps of bees that move: more than show that an id is that of several

  double fastest_mps_;
  std::vector<double> speeds_mps_ = {};
};

}  // namespace beespace::io
