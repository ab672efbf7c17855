// What a verification says that holds: distances, or of one bee alone, of which there is no pair,
// what it was compared with instead.
#pragma once

#include <cstddef>
#include <string>

namespace beespace::cli {

class HoldingWords {
 public:
  HoldingWords(std::size_t bees, bool obstacles, bool limits);

  // "holds"; "one bee, so that there is no pair to compare; its limits hold". In bold, the latter
  // from its limits on; `more` goes with it: " in the known time".
  [[nodiscard]] std::string text(const std::string& more = "") const;
  // The same without any emphasis.
  [[nodiscard]] std::string plain(const std::string& more = "") const;

 private:
  std::string alone_;
  std::string what_ = "holds";
};

// Of one bee without limits and obstacles.
inline constexpr const char* kNothingToCheck =
    "there is one bee, so that there is no pair, and no limit to check it by (--max-speed, ...)";
inline constexpr const char* kNoPair = "there is one bee, and no pair";

}  // namespace beespace::cli
