// Who has been heard of and is nowhere that is known: as long as there are such, the verdict says
// so, and advice certifies no bee.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace beespace::cli {

class UnplacedBees {
 public:
  // Of more than can be kept it is known for good that there are some.
  void add(std::string_view id) {
    if (ids_.size() < kMost) {
      ids_.emplace(id);
    } else {
      for_good_ = true;
    }
  }
  // Some bee that nothing places again.
  void add_for_good() { for_good_ = true; }

  // Whether it was one of them.
  bool remove(std::string_view id) {
    const auto known = ids_.find(id);
    if (known == ids_.end()) return false;
    ids_.erase(known);
    return true;
  }

  [[nodiscard]] bool any() const { return for_good_ || !ids_.empty(); }
  // Of those that are kept.
  [[nodiscard]] std::size_t count() const { return ids_.size(); }

 private:
  static constexpr std::size_t kMost = 100'000;

  std::set<std::string, std::less<>> ids_;
  bool for_good_ = false;
};

}  // namespace beespace::cli
