#include "out_of_core/recorded/joined_conflicts.hpp"

#include "exact/validate.hpp"

#include <optional>
#include <vector>

namespace beespace::out_of_core {

namespace {

constexpr std::size_t kConflictsAtOnce = 1024;

}  // namespace

Status JoinedConflicts::add(std::uint64_t window, std::span<const Conflict> conflicts,
                            const WindowTracks& tracks, Crew& crew) {
  for (const Conflict& found : conflicts) {
    rows_.add({{tracks.agent(found.first), tracks.agent(found.second), found.begins_s,
                found.closest_s, found.ends_s, found.closest_m},
               window});
    if (!rows_.full()) continue;
    if (auto status = rows_.flush(crew); !status) return status;
  }
  return std::monostate{};
}

bool JoinedConflicts::goes_on(const Row& before, const Row& next) {
  return before.conflict.first == next.conflict.first &&
         before.conflict.second == next.conflict.second && before.window + 1 == next.window &&
         next.conflict.begins_s <= before.conflict.ends_s;
}

void JoinedConflicts::join(Row& before, const Row& next) {
  before.window = next.window;
  before.conflict.ends_s = next.conflict.ends_s;
  // Of equally close instants the first.
  if (next.conflict.closest_m < before.conflict.closest_m) {
    before.conflict.closest_m = next.conflict.closest_m;
    before.conflict.closest_s = next.conflict.closest_s;
  }
}

Status JoinedConflicts::visit(std::uint64_t max_results, const LargeConflictVisitor& visit,
                              Crew& crew) {
  if (auto status = rows_.settle(crew); !status) return status;
  std::vector<LargeConflict> told;
  std::optional<Row> open;
  std::uint64_t count = 0;
  const auto end = [&] {
    told.push_back(open->conflict);
    ++count;
    if (told.size() < kConflictsAtOnce) return;
    visit(told);
    told.clear();
  };
  auto status = rows_.for_each([&](const Row& row) {
    if (open && goes_on(*open, row)) {
      join(*open, row);
      return true;
    }
    if (open) end();
    open = row;
    return count < max_results;
  });
  if (!status) return status;
  if (open && count == max_results) return core::too_many_results(max_results);
  if (open) end();
  if (!told.empty()) visit(told);
  return std::monostate{};
}

}  // namespace beespace::out_of_core
