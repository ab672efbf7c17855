#include "io/column_choice.hpp"

#include "io/excerpt.hpp"
#include "io/header_words.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace beespace::io {
namespace {

using Found = std::vector<std::vector<std::size_t>>;  // by role: the columns of that role

constexpr std::size_t kRoles = 8;

std::size_t index_of(Role role) {
  return static_cast<std::size_t>(role);
}

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

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, "--columns: " + std::move(message), {}};
}

std::string list_columns(const ColumnsSeen& seen) {
  constexpr std::size_t kMostListed = 20;
  if (seen.names.empty()) {
    return "there are " + std::to_string(seen.count) +
           (seen.count == 1 ? " column and no header" : " columns and no header");
  }
  std::string text = "the columns are";
  for (std::size_t i = 0; i < seen.names.size() && i < kMostListed; ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(i + 1) + " " + excerpt(seen.names[i]);
  }
  return text + (seen.names.size() > kMostListed ? ", ..." : "");
}

constexpr std::string_view kSayWhich =
    "say which hold the position with --columns, for example --columns lon=1,lat=2,height=3 or "
    "--columns x=1,y=2,z=3";

// ---- As the caller says --------------------------------------------------------------------

struct Wish {
  Role role = Role::kNone;
  std::string column = {};
};

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

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

Result<std::size_t> find_column(const std::string& wanted, const ColumnsSeen& seen) {
  std::size_t number = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, number);
  if (parsed.ptr == end) {
    if (parsed.ec == std::errc() && number >= 1 && number <= seen.count) return number - 1;
    return missing("there is no column " + wanted + "; " + list_columns(seen));
  }
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    if (seen.names[i] == wanted) return i;
  }
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    if (lower(seen.names[i]) == lower(wanted)) return i;
  }
  return missing("there is no column named " + excerpt(wanted) + "; " + list_columns(seen));
}

// ---- What both ways share ------------------------------------------------------------------

std::string frame_words(bool geographic, bool third) {
  if (geographic) return third ? "longitude, latitude and height" : "longitude and latitude";
  return third ? "x, y and z" : "x and y";
}

std::optional<Error> unit_problem(const ColumnsSeen& seen, const ColumnChoice& choice) {
  for (std::size_t axis = 0; axis < choice.dimensions && !seen.names.empty(); ++axis) {
    const std::size_t column = choice.axes[axis];
    const std::string unit = read_header_word(seen.names[column]).foreign_unit;
    if (unit.empty()) continue;
    Error error{ErrorCode::kUnsupportedFormat,
                "column " + excerpt(seen.names[column]) + " is in '" + unit +
                    "'; convert it first: beespace reads degrees and metres (1 ft = 0.3048 m)",
                {}};
    error.place.column = column + 1;
    return error;
  }
  return std::nullopt;
}

Result<ColumnChoice> choose_as_wished(const std::vector<Wish>& wishes, const ColumnsSeen& seen) {
  std::array<std::optional<std::size_t>, kRoles> columns = {};
  for (const Wish& wish : wishes) {
    const auto column = find_column(wish.column, seen);
    if (!column) return column.error();
    columns[index_of(wish.role)] = *column;
  }
  const auto at = [&columns](Role role) { return columns[index_of(role)]; };
  const bool geographic = at(Role::kLongitude) || at(Role::kLatitude);
  ColumnChoice choice;
  const auto third = geographic ? at(Role::kHeight) : at(Role::kZ);
  choice.axes[0] = *(geographic ? at(Role::kLongitude) : at(Role::kX));
  choice.axes[1] = *(geographic ? at(Role::kLatitude) : at(Role::kY));
  choice.axes[2] = third.value_or(0);
  choice.dimensions = third ? 3 : 2;
  choice.id = at(Role::kId);
  choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
  choice.reason = "--columns names " + frame_words(geographic, third.has_value());
  if (auto problem = unit_problem(seen, choice)) return *std::move(problem);
  return choice;
}

// Wishes that no file can fulfil.
std::optional<Error> wishes_problem(const std::vector<Wish>& wishes) {
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
  for (const Wish& wish : wishes) {
    for (const Wish& other : wishes) {
      if (&wish != &other && wish.column == other.column && wish.role != Role::kId &&
          other.role != Role::kId) {
        return invalid("column " + excerpt(wish.column) + " cannot be both " +
                       std::string(role_name(wish.role)) + " and " +
                       std::string(role_name(other.role)));
      }
    }
  }
  return std::nullopt;
}

// ---- As the header says --------------------------------------------------------------------

struct Header {
  std::vector<HeaderWord> words;
  Found by_role = Found(kRoles);

  [[nodiscard]] const std::vector<std::size_t>& columns(Role role) const {
    return by_role[index_of(role)];
  }
  [[nodiscard]] bool has(Role role) const { return !columns(role).empty(); }
};

Header read_header(const ColumnsSeen& seen) {
  Header header;
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    header.words.push_back(read_header_word(seen.names[i]));
    header.by_role[index_of(header.words.back().role)].push_back(i);
  }
  // Where a coordinate comes in several units, the one that can be read is meant.
  for (auto& columns : header.by_role) {
    const auto foreign = [&header](std::size_t i) { return !header.words[i].foreign_unit.empty(); };
    if (std::all_of(columns.begin(), columns.end(), foreign)) continue;
    columns.erase(std::remove_if(columns.begin(), columns.end(), foreign), columns.end());
  }
  return header;
}

// The third coordinate by its name, or the reason why it cannot be told.
Result<std::optional<std::size_t>> find_third(const Header& header, const ColumnsSeen& seen,
                                              bool geographic) {
  const Role first_choice = geographic ? Role::kHeight : Role::kZ;
  const Role other = geographic ? Role::kZ : Role::kHeight;
  for (const Role role : {first_choice, other}) {
    if (header.columns(role).size() > 1) {
      return missing("several columns look like " + std::string(role_name(first_choice)) + "; " +
                     std::string(kSayWhich) + " (" + list_columns(seen) + ")");
    }
    if (header.has(role)) return std::optional<std::size_t>(header.columns(role).front());
  }
  for (const std::size_t column : header.columns(Role::kNone)) {
    if (column < seen.numeric.size() && seen.numeric[column]) {
      return missing("column " + excerpt(seen.names[column]) + " may or may not be the " +
                     (geographic ? "height" : "z") + "; " + std::string(kSayWhich) + " (" +
                     list_columns(seen) + ")");
    }
  }
  return std::optional<std::size_t>();
}

Result<ColumnChoice> choose_by_names(const Header& header, const ColumnsSeen& seen,
                                     bool geographic) {
  const Role first = geographic ? Role::kLongitude : Role::kX;
  const Role second = geographic ? Role::kLatitude : Role::kY;
  for (const Role role : {first, second}) {
    if (header.columns(role).size() > 1) {
      return missing("several columns look like " + std::string(role_name(role)) + "; " +
                     std::string(kSayWhich) + " (" + list_columns(seen) + ")");
    }
  }
  const auto third = find_third(header, seen, geographic);
  if (!third) return third.error();
  ColumnChoice choice;
  choice.axes = {header.columns(first).front(), header.columns(second).front(),
                 third.value().value_or(0)};
  choice.dimensions = third.value().has_value() ? 3 : 2;
  bool course = true;
  bool agreed = true;
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    const HeaderWord& word = header.words[choice.axes[axis]];
    course = course && word.course_format;
    if (axis < 2) agreed = agreed && word.frame == (geographic ? Frame::kWgs84 : Frame::kMetres);
  }
  if (agreed) choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
  choice.reason = course ? "the header speaks of the coordinates of bees, as the course format does"
                         : "the header names " + frame_words(geographic, third.value().has_value());
  return choice;
}

// The columns that are not known to be something else, in their order.
Result<ColumnChoice> choose_in_order(const Header& header, const ColumnsSeen& seen,
                                     std::optional<std::size_t> id) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < seen.count; ++i) {
    const bool named_id = i < header.words.size() && header.words[i].role == Role::kId;
    // A delimiter at the end of every line makes a nameless, empty last column.
    const bool nothing = i + 1 == seen.count && i >= 2 && i < seen.numeric.size() &&
                         !seen.numeric[i] && !seen.names.empty() && seen.names[i].empty();
    if (i != id && !named_id && !nothing) columns.push_back(i);
  }
  for (std::size_t i = 0; i < header.words.size(); ++i) {
    const Role role = header.words[i].role;
    const bool third = role == Role::kHeight || role == Role::kZ;
    if (role == Role::kNone || role == Role::kId) continue;
    if (third && columns.size() == 3 && columns[2] == i) continue;
    return missing("the header names " + excerpt(seen.names[i]) +
                   " but not the columns that belong to it; " + std::string(kSayWhich) + " (" +
                   list_columns(seen) + ")");
  }
  if (columns.size() != 2 && columns.size() != 3) {
    return missing(std::string(columns.size() < 2 ? "a position needs two or three columns"
                                                  : "cannot tell which columns hold the position") +
                   "; " + std::string(kSayWhich) + " (" + list_columns(seen) + ")");
  }
  ColumnChoice choice;
  choice.dimensions = columns.size();
  std::copy(columns.begin(), columns.end(), choice.axes.begin());
  const bool course = !header.words.empty() &&
                      std::all_of(columns.begin(), columns.end(),
                                  [&header](auto i) { return header.words[i].course_format; });
  if (course) {
    choice.evidence = Frame::kWgs84;
    choice.reason = "the header speaks of the coordinates of bees, as the course format does";
  }
  return choice;
}

Result<ColumnChoice> choose_by_header(const Header& header, const ColumnsSeen& seen,
                                      std::optional<std::size_t> id, Frame frame) {
  const bool geographic = header.has(Role::kLongitude) && header.has(Role::kLatitude);
  const bool metres = header.has(Role::kX) && header.has(Role::kY);
  if (geographic && metres && frame == Frame::kAuto) {
    return missing(
        "the header names both longitude, latitude and x, y; say which to take with --crs wgs84 "
        "or --crs metres");
  }
  if (geographic && (!metres || frame == Frame::kWgs84)) {
    return choose_by_names(header, seen, true);
  }
  if (metres) return choose_by_names(header, seen, false);
  return choose_in_order(header, seen, id);
}

}  // namespace

Result<ColumnChoice> choose_columns(const ColumnsSeen& seen, const LoadOptions& options) {
  std::optional<std::size_t> id;
  if (!options.columns.empty()) {
    const auto wishes = parse_wishes(options.columns);
    if (!wishes) return wishes.error();
    if (auto problem = wishes_problem(wishes.value())) return *std::move(problem);
    const bool only_id = wishes.value().size() == 1 && wishes.value().front().role == Role::kId;
    if (!only_id) return choose_as_wished(wishes.value(), seen);
    const auto column = find_column(wishes.value().front().column, seen);
    if (!column) return column.error();
    id = column.value();
  }
  const Header header = read_header(seen);
  auto choice = choose_by_header(header, seen, id, options.frame);
  if (!choice) return choice;
  if (auto problem = unit_problem(seen, choice.value())) return *std::move(problem);
  if (!id && header.has(Role::kId)) id = header.columns(Role::kId).front();
  choice.value().id = id;
  return choice;
}

}  // namespace beespace::io
