#include "cli/detect/out_of_core/large_ids.hpp"

#include "analysis/snapshot/shown_ids.hpp"
#include "cli/detect/out_of_core/sorted_rows.hpp"
#include "io/bytes/number_text.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

// Ids of one hash, of which mostly all are the same.
class Alike {
 public:
  struct Met {
    std::string id;
    std::uint64_t row;
  };

  [[nodiscard]] bool empty() const { return met_.empty(); }
  void clear() { met_.clear(); }

  // The first one with that id; or nothing, and it is kept from now on.
  const Met* find_or_keep(const std::string& id, std::uint64_t row) {
    for (const Met& met : met_) {
      if (met.id == id) return &met;
    }
    met_.push_back({id, row});
    return nullptr;
  }

 private:
  std::vector<Met> met_;
};

}  // namespace

void LargeIds::append(std::string& out, LargeId point) const {
  const std::string_view id = store_ == nullptr ? std::string_view() : store_->text(point);
  if (analysis::is_empty_id(id)) return io::append_exact(out, row(point));
  analysis::append_id(out, id);
}

std::string LargeIds::text(LargeId point) const {
  std::string out;
  append(out, point);
  return out;
}

void LargeIds::write(io::JsonWriter& json, LargeId point) const {
  const std::string_view id = store_ == nullptr ? std::string_view() : store_->text(point);
  if (analysis::is_empty_id(id)) {
    json.value(row(point));
  } else {
    json.value(id);
  }
}

Result<io::RepeatedIds> LargeIds::find_repeated(std::uint64_t points, const std::string& folder,
                                                std::size_t memory_bytes) const {
  io::RepeatedIds repeated;
  if (store_ == nullptr) return repeated;
  SortedRows hashes(folder, memory_bytes);
  for (LargeId point = 0; point < points && store_->status() && hashes.status(); ++point) {
    const std::string_view id = store_->text(point);
    if (!id.empty()) hashes.add({std::hash<std::string_view>()(id), point, 0.0});
  }
  // The points of one hash come in their order. Texts are looked at where one comes again only.
  Alike alike;
  std::optional<LargeRow> last;
  repeated.second_row = std::numeric_limits<std::uint64_t>::max();
  hashes.for_each([&](const LargeRow& row) {
    const LargeRow before = last.value_or(row);
    const bool again = last && before.first == row.first;
    last = row;
    if (!again) return alike.clear();
    if (alike.empty()) alike.find_or_keep(std::string(store_->text(before.second)), before.second);
    const std::string id(store_->text(row.second));
    const Alike::Met* const known = alike.find_or_keep(id, row.second);
    if (known == nullptr) return;
    ++repeated.count;
    if (row.second > repeated.second_row) return;
    repeated.id = id;
    repeated.first_row = known->row;
    repeated.second_row = row.second;
  });
  if (!store_->status()) return store_->status().error();
  if (!hashes.status()) return hashes.status().error();
  if (repeated.count == 0) return io::RepeatedIds();
  repeated.first_row = row(repeated.first_row);
  repeated.second_row = row(repeated.second_row);
  return repeated;
}

}  // namespace beespace::cli
