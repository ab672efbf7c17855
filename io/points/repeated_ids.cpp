#include "io/points/repeated_ids.hpp"

#include <bit>
#include <cstddef>
#include <deque>
#include <functional>
#include <numeric>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

// Ids that were met, and where: open addressing, as there are as many as records.
class MetIds {
 public:
  explicit MetIds(std::size_t most)
      : slots_(std::bit_ceil(2 * most + 2), 0), mask_(slots_.size() - 1) {
    met_.reserve(most);
  }

  struct Met {
    std::string_view id;
    std::uint64_t row;
  };

  // The one before with that id; or nothing, and it is kept from now on.
  const Met* find_or_keep(std::string_view id, std::uint64_t row) {
    std::size_t slot = std::hash<std::string_view>()(id) & mask_;
    while (slots_[slot] != 0) {
      const Met& known = met_[slots_[slot] - 1];
      if (known.id == id) return &known;
      slot = (slot + 1) & mask_;
    }
    met_.push_back({id, row});
    slots_[slot] = met_.size();
    return nullptr;
  }

 private:
  std::vector<std::size_t> slots_;  // a place in met_, counted from 1; 0: nothing
  std::size_t mask_;
  std::vector<Met> met_;
};

bool lies_in(std::string_view part, std::string_view whole) {
  const std::less_equal<const char*> before;
  return before(whole.data(), part.data()) &&
         before(part.data() + part.size(), whole.data() + whole.size());
}

}  // namespace

RepeatedIds find_repeated_ids(const LoadedPoints& loaded) {
  RepeatedIds repeated;
  if (!has_id_column(loaded)) return repeated;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  MetIds met(all.size());
  std::deque<std::string> copies;  // of ids that do not stand in the input as they are
  for_each_record(loaded, all, [&](const Record& record) {
    std::string_view id = record.id;
    if (id.empty()) return;
    if (!lies_in(id, record.text)) id = copies.emplace_back(id);
    const MetIds::Met* const known = met.find_or_keep(id, record.row);
    if (known == nullptr || repeated.count++ > 0) return;
    repeated.id = std::string(id);
    repeated.first_row = known->row;
    repeated.second_row = record.row;
  });
  return repeated;
}

}  // namespace beespace::io
