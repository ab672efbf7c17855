#include "io/table/column_wishes.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, "--columns: " + std::move(message), {}};
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

Role role_of_wish(std::string_view word) {
  for (const Role role : {Role::kLongitude, Role::kLatitude, Role::kHeight, Role::kX, Role::kY,
                          Role::kZ, Role::kId}) {
    if (word == role_name(role)) return role;
  }
  return Role::kNone;
}

Result<std::vector<Wish>> parse_wishes(std::string_view text) {
  if (trimmed(text).empty()) {
    return invalid("it is empty; write lon=1,lat=2,height=3 or x=1,y=2,z=3, or leave it out");
  }
  std::vector<Wish> wishes;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item.find('=');
    Wish wish;
    if (equals != std::string_view::npos) {
      wish.role = role_of_wish(trimmed(item.substr(0, equals)));
      wish.column = trimmed(item.substr(equals + 1));
    }
    if (wish.role == Role::kNone || wish.column.empty()) {
      return invalid(excerpt(item) +
                     " is not understood; write role=column, where the role is lon, lat, height, "
                     "x, y, z or id and the column a number (from 1) or a name");
    }
    for (const Wish& other : wishes) {
      if (other.role == wish.role) {
        return invalid(std::string(role_name(wish.role)) + " is given twice; keep one");
      }
    }
    wishes.push_back(std::move(wish));
    if (comma == std::string_view::npos) return wishes;
    text.remove_prefix(comma + 1);
  }
}

// Wishes that no file can fulfil.
std::optional<Error> wishes_problem(const std::vector<Wish>& wishes, Frame frame) {
  const auto has = [&wishes](Role role) {
    return std::any_of(wishes.begin(), wishes.end(),
                       [role](const Wish& wish) { return wish.role == role; });
  };
  const bool geographic = has(Role::kLongitude) || has(Role::kLatitude) || has(Role::kHeight);
  const bool metres = has(Role::kX) || has(Role::kY) || has(Role::kZ);
  if (geographic && metres) {
    return invalid("lon, lat, height and x, y, z do not go together; use one set");
  }
  if (geographic && !(has(Role::kLongitude) && has(Role::kLatitude))) {
    return invalid(has(Role::kLongitude)  ? "lon needs lat too"
                   : has(Role::kLatitude) ? "lat needs lon too"
                                          : "height needs lon and lat too");
  }
  if (metres && !(has(Role::kX) && has(Role::kY))) {
    return invalid(has(Role::kX)   ? "x needs y too"
                   : has(Role::kY) ? "y needs x too"
                                   : "z needs x and y too");
  }
  if ((geographic && frame == Frame::kMetres) || (metres && frame == Frame::kWgs84)) {
    return invalid(std::string(geographic ? "lon, lat and height are in degrees, but --crs metres"
                                          : "x, y and z are in metres, but --crs wgs84") +
                   " is given too; keep one of them");
  }
  return std::nullopt;
}

// The only column for which `same` holds; nothing when there is none.
template <typename Same>
Result<std::optional<std::size_t>> only_column(std::string_view role, const std::string& wanted,
                                               const ColumnsSeen& seen, const Same& same) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    if (!same(seen.names[i])) continue;
    if (found) {
      return missing("columns " + std::to_string(*found + 1) + " and " + std::to_string(i + 1) +
                     " are both named " + excerpt(wanted) +
                     "; give the number: " + std::string(role) + "=" + std::to_string(*found + 1) +
                     " or " + std::string(role) + "=" + std::to_string(i + 1));
    }
    found = i;
  }
  return found;
}

}  // namespace

std::string_view role_name(Role role) {
  switch (role) {
    case Role::kLongitude:
      return "lon";
    case Role::kLatitude:
      return "lat";
    case Role::kHeight:
      return "height";
    case Role::kX:
      return "x";
    case Role::kY:
      return "y";
    case Role::kZ:
      return "z";
    case Role::kId:
      return "id";
    case Role::kNone:
      break;
  }
  return "none";
}

std::string list_columns(const ColumnsSeen& seen) {
  constexpr std::size_t kMostListed = 20;
  if (seen.names.empty()) {
    return seen.count == 1 ? "there is 1 column and no header"
                           : "there are " + std::to_string(seen.count) + " columns and no header";
  }
  std::string text = "the columns are";
  for (std::size_t i = 0; i < seen.names.size() && i < kMostListed; ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(i + 1) + " " + excerpt(seen.names[i]);
  }
  return text + (seen.names.size() > kMostListed ? ", ..." : "");
}

Result<std::vector<Wish>> read_wishes(std::string_view text, Frame frame) {
  auto wishes = parse_wishes(text);
  if (!wishes) return wishes;
  if (auto problem = wishes_problem(wishes.value(), frame)) return *std::move(problem);
  return wishes;
}

Result<std::size_t> find_wished_column(const Wish& wish, const ColumnsSeen& seen) {
  return find_wished_column(role_name(wish.role), wish.column, seen);
}

Result<std::size_t> find_wished_column(std::string_view role, const std::string& wanted,
                                       const ColumnsSeen& seen) {
  std::size_t number = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, number);
  if (parsed.ptr == end) {
    if (parsed.ec == std::errc() && number >= 1 && number <= seen.count) return number - 1;
    return missing("there is no column " + wanted + "; " + list_columns(seen));
  }
  const auto exact = only_column(role, wanted, seen,
                                 [&wanted](const std::string& name) { return name == wanted; });
  if (!exact) return exact.error();
  if (exact.value()) return *exact.value();
  const std::string lower = lower_case(wanted);
  const auto near = only_column(
      role, wanted, seen, [&lower](const std::string& name) { return lower_case(name) == lower; });
  if (!near) return near.error();
  if (near.value()) return *near.value();
  return missing("there is no column named " + excerpt(wanted) + "; " + list_columns(seen));
}

}  // namespace beespace::io
