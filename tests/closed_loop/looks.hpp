// The output of `watch --advise`, one round of advice (look) after the other.
#pragma once

#include "tests/closed_loop/flown.hpp"

#include <map>
#include <optional>
#include <string>

namespace beespace::closed_loop {

// The advice for one bee.
struct BeeAdvice {
  std::optional<Vector> velocity;  // none: no velocity advised
  bool certified = false;
  std::string because;
};

// One round of advice.
struct Look {
  double time_s = 0;
  double effective_s = 0;
  std::map<std::string, BeeAdvice> bees;  // those that are named
  std::string closing;                    // the line that ends it
};

// Puts the lines of looks together.
class Looks {
 public:
  // The look that this line ends; none where it goes on, or the line is about something else.
  std::optional<Look> take(const std::string& line);

 private:
  Look open_;
};

// A member of a line of JSON that has no objects in arrays; none where it is not there.
std::optional<double> number_in(const std::string& line, const std::string& name);
std::optional<std::string> text_in(const std::string& line, const std::string& name);

}  // namespace beespace::closed_loop
