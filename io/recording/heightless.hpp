// Who has no height in any record while others have: it would be compared with none, though it is
// known where it was over ground. What is meant is asked, with what to type for either.
#pragma once

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {

// What --columns says of a table: to take all of it over ground, or to mean its heights.
struct HeightColumns {
  std::string flat = {};     // "lon=4,lat=5"
  std::string heights = {};  // "lon=4,lat=5,height=6"; empty: there are none, or it is said which
};

class Heightless {
 public:
  // A record of that bee is left out since it has no height.
  void take(std::string_view id) {
    const auto [known, is_new] = places_.try_emplace(std::string(id), bees_.size());
    if (is_new) bees_.push_back({std::string(id), 0});
    ++bees_[known->second].records;
  }
  [[nodiscard]] bool any() const { return !bees_.empty(); }

  // kInvalidArgument where some of them, by `is_placed` of an id, have no record with a height.
  // `given` is what --columns says already.
  template <class IsPlaced>
  [[nodiscard]] std::optional<Error> question(const HeightColumns& columns,
                                              const std::string& given, IsPlaced is_placed) const {
    if (columns.heights.empty()) return std::nullopt;
    std::vector<std::string> ids;
    std::uint64_t records = 0;
    for (const Bee& bee : bees_) {
      if (is_placed(bee.id)) continue;
      ids.push_back(bee.id);
      records += bee.records;
    }
    if (ids.empty()) return std::nullopt;
    return question(ids, records, columns, given);
  }

 private:
  struct Bee {
    std::string id;
    std::uint64_t records;
  };
  static Error question(const std::vector<std::string>& ids, std::uint64_t records,
                        const HeightColumns& columns, const std::string& given);

  std::unordered_map<std::string, std::size_t> places_;  // in bees_, by id
  std::vector<Bee> bees_;
};

}  // namespace beespace::io
