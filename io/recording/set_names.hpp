// Names of bees that are of a study, a trial, a video or a day: in another one the same name is
// another bee.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace beespace::io {

class SetNames {
 public:
  // What to call the bee `id` of that set, the same for every call: its id where no bee of another
  // set has come with it before, otherwise "id (set)". As long as this lives.
  std::string_view name_of(std::string_view id, std::string_view set);

  // How many bees have another name than their id, and the first of these names.
  [[nodiscard]] std::uint64_t told_apart() const { return told_apart_; }
  [[nodiscard]] const std::string& example() const { return example_; }

 private:
  std::unordered_map<std::string, std::string> names_;  // by the id and the set
  std::unordered_set<std::string> taken_;               // of the names
  std::string key_;
  std::uint64_t told_apart_ = 0;
  std::string example_;
};

}  // namespace beespace::io
