#include "cli/detect/reports/report.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace beespace::cli {
namespace {

struct Membership {
  std::uint32_t group = 0;
  std::uint32_t size = 0;
};

std::vector<Membership> memberships(const IdRows& groups, std::size_t bees) {
  std::vector<Membership> all(bees);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Membership here{static_cast<std::uint32_t>(i),
                          static_cast<std::uint32_t>(groups[i].size())};
    for (const PointId bee : groups[i]) all[bee] = here;
  }
  return all;
}

std::string finding(const IdRows& groups) {
  if (groups.size() == 0) return "none";
  std::size_t largest = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) largest = std::max(largest, groups[i].size());
  return io::grouped(groups.size()) + (groups.size() == 1 ? ", of " : ", the largest of ") +
         io::grouped(largest) + " bees";
}

}  // namespace

Result<ReportFound> report_groups(const Question& question) {
  GroupTable table;
  const Status found = question.engine.find_conflict_groups(
      question.points, question.search.without_limit(), table.groups);
  if (!found) return found.error();
  const auto of =
      std::make_shared<std::vector<Membership>>(memberships(table.groups, question.points.size()));
  const auto group = [of](PointId bee) -> Cell { return std::uint64_t{(*of)[bee].group}; };
  const auto size = [of](PointId bee) -> Cell { return std::uint64_t{(*of)[bee].size}; };
  std::vector<PointId> at_risk =
      bees_that(of->size(), [&](std::size_t bee) { return (*of)[bee].size > 0; });
  table.members = {at_risk, {{"group", false, group}, {"group_size", false, size}}};
  std::string said = finding(table.groups);
  return ReportFound{Table{std::move(table), std::move(said)}, std::move(at_risk)};
}

}  // namespace beespace::cli
