#include "io/recording/heightless.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>

namespace beespace::io {

Error Heightless::question(const std::vector<std::string>& ids, std::uint64_t records,
                           const HeightColumns& columns, const std::string& given) {
  constexpr std::size_t kMostNamed = 3;
  const std::size_t named = std::min(kMostNamed, ids.size());
  std::string names;
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) names += i + 1 == ids.size() ? " and " : ", ";
    names += excerpt(ids[i]);
  }
  if (ids.size() > named) {
    names.append(" and ").append(grouped(std::uint64_t{ids.size() - named})).append(" more");
  }
  const bool one = ids.size() == 1;
  const std::string before = "--columns " + (given.empty() ? given : given + ",");
  std::string text = names;
  text.append(one ? " has no height in any of its " : " have no height in any of their ")
      .append(counted(records, "record", "records"))
      .append(", while others have: ")
      .append(one ? "it" : "they")
      .append(
          " would be compared with none. To compare all over ground, whatever their heights, "
          "add ")
      .append(before)
      .append(columns.flat)
      .append(one ? "; to leave it out as known nowhere, add "
                  : "; to leave them out as known nowhere, add ")
      .append(before)
      .append(columns.heights);
  return {ErrorCode::kInvalidArgument, std::move(text), {}};
}

}  // namespace beespace::io
