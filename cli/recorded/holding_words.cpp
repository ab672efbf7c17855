#include "cli/recorded/holding_words.hpp"

#include "cli/console/terminal.hpp"

namespace beespace::cli {

HoldingWords::HoldingWords(std::size_t bees, bool obstacles, bool limits) {
  if (bees != 1) return;
  alone_ = "one bee, so that there is no pair to compare; ";
  what_ = obstacles ? "it keeps clear of obstacles" : "its limits hold";
  if (obstacles && limits) what_ += ", and its limits hold";
}

std::string HoldingWords::text(const std::string& more) const {
  return alone_ + bold(what_ + more);
}

std::string HoldingWords::plain(const std::string& more) const {
  return alone_ + what_ + more;
}

}  // namespace beespace::cli
