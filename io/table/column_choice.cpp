#include "io/table/column_choice.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_wishes.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/header_words.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

using Found = std::vector<std::vector<std::size_t>>;  // by role: the columns of that role

constexpr std::size_t kRoles = 8;

std::size_t index_of(Role role) {
  return static_cast<std::size_t>(role);
}

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

std::string columns_text(const std::vector<std::pair<Role, std::size_t>>& roles) {
  std::string text = "--columns ";
  for (std::size_t i = 0; i < roles.size(); ++i) {
    text.append(i == 0 ? "" : ",").append(role_name(roles[i].first)).append("=");
    text += std::to_string(roles[i].second + 1);
  }
  return text;
}

// ---- What both ways share ------------------------------------------------------------------

std::string frame_words(bool geographic, bool third) {
  if (geographic) return third ? "longitude, latitude and height" : "longitude and latitude";
  return third ? "x, y and z" : "x and y";
}

Result<ColumnChoice> choose_as_wished(const std::vector<Wish>& wishes, const ColumnsSeen& seen) {
  std::array<std::optional<std::size_t>, kRoles> columns = {};
  for (const Wish& wish : wishes) {
    const auto column = find_wished_column(wish, seen);
    if (!column) return column.error();
    for (const Wish& other : wishes) {
      if (wish.role == Role::kId || other.role == Role::kId) continue;
      if (columns[index_of(other.role)] != *column) continue;
      return Error{ErrorCode::kInvalidArgument,
                   "--columns: column " + std::to_string(*column + 1) + " cannot be both " +
                       std::string(role_name(other.role)) + " and " +
                       std::string(role_name(wish.role)),
                   {}};
    }
    columns[index_of(wish.role)] = *column;
  }
  const auto at = [&columns](Role role) { return columns[index_of(role)]; };
  const bool geographic = at(Role::kLongitude).has_value();
  ColumnChoice choice;
  const auto third = geographic ? at(Role::kHeight) : at(Role::kZ);
  choice.axes[0] = *(geographic ? at(Role::kLongitude) : at(Role::kX));
  choice.axes[1] = *(geographic ? at(Role::kLatitude) : at(Role::kY));
  choice.axes[2] = third.value_or(0);
  choice.dimensions = third ? 3 : 2;
  choice.id = at(Role::kId);
  choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
  choice.reason = "--columns names " + frame_words(geographic, third.has_value());
  return choice;
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

bool is_taken(const ColumnsSeen& seen, std::size_t column) {
  return column < seen.taken.size() && seen.taken[column];
}

Header read_header(const ColumnsSeen& seen, std::optional<std::size_t> id, HeightSource heights) {
  Header header;
  const TableSource* const source = source_of(seen.names);
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    header.words.push_back(read_header_word(seen.names[i]));
    if (i == id || is_taken(seen, i)) header.words.back() = {};
    if (i == id) header.words.back().role = Role::kId;
    const KnownColumn* const known = source != nullptr ? source->find(seen.names[i]) : nullptr;
    if (known != nullptr) header.words.back().datum = known->datum;
    header.by_role[index_of(header.words.back().role)].push_back(i);
  }
  // Where a coordinate comes several times, the one that can be read is meant, the one in metres,
  // the one without "uav" before its name, and the height of the wanted kind.
  const auto converted = [&header](std::size_t i) {
    const Unit unit = header.words[i].unit;
    return unit != Unit::kUnstated && unit != Unit::kMetre;
  };
  const auto unwanted = [&header, heights](std::size_t i) {
    const bool pressure = header.words[i].datum == HeightDatum::kPressure;
    return pressure != (heights == HeightSource::kPressure);
  };
  const auto foreign = [&header](std::size_t i) { return !header.words[i].foreign_unit.empty(); };
  const auto prefixed = [&header](std::size_t i) { return !header.words[i].prefix.empty(); };
  const auto leave_out = [](std::vector<std::size_t>& columns, const auto& worse) {
    if (std::all_of(columns.begin(), columns.end(), worse)) return;
    columns.erase(std::remove_if(columns.begin(), columns.end(), worse), columns.end());
  };
  for (auto& columns : header.by_role) {
    leave_out(columns, foreign);
    leave_out(columns, prefixed);
    leave_out(columns, unwanted);
    leave_out(columns, converted);
  }
  return header;
}

// Whether a name that is not understood still has something of that coordinate in it.
bool resembles(const std::string& name, Role role) {
  constexpr std::array<std::string_view, 8> kHeight = {"alt",  "hei", "elev",  "höhe",
                                                       "hoeh", "hgt", "высот", "depth"};
  constexpr std::array<std::string_view, 6> kLongitude = {"lon",   "lng",  "läng",
                                                          "laeng", "долг", "boylam"};
  constexpr std::array<std::string_view, 6> kLatitude = {"lat", "breit", "breed",
                                                         "шир", "enlem", "latitud"};
  const std::string lower = lower_case(name);
  const auto has_one_of = [&lower](const auto& stems) {
    return std::any_of(stems.begin(), stems.end(), [&lower](std::string_view stem) {
      return lower.find(stem) != std::string::npos;
    });
  };
  if (role == Role::kHeight || role == Role::kZ) return has_one_of(kHeight);
  if (role == Role::kLongitude) return has_one_of(kLongitude);
  return role == Role::kLatitude && has_one_of(kLatitude);
}

// Whether a column may hold numbers, as far as was looked.
bool may_be_number(const ColumnsSeen& seen, std::size_t column) {
  return column >= seen.contents.size() || seen.contents[column] != ColumnContent::kText;
}

// The column to offer for a role: by its name, or else the first that is free.
std::size_t column_to_offer(Role role, const Header& header, const ColumnsSeen& seen,
                            const std::vector<bool>& used) {
  if (header.has(role)) return header.columns(role).front();
  for (std::size_t i = 0; i < seen.names.size() && i < seen.count; ++i) {
    if (!used[i] && resembles(seen.names[i], role)) return i;
  }
  // Beside two that have names a third is not just any column.
  const bool third = role == Role::kHeight || role == Role::kZ;
  const bool named = role == Role::kHeight
                         ? header.has(Role::kLongitude) && header.has(Role::kLatitude)
                         : header.has(Role::kX) && header.has(Role::kY);
  if (third && named) return seen.count;
  for (std::size_t i = 0; i < seen.count; ++i) {
    const bool other = i < seen.names.size() && (resembles(seen.names[i], Role::kLongitude) ||
                                                 resembles(seen.names[i], Role::kLatitude));
    const bool geographic = role == Role::kLongitude || role == Role::kLatitude;
    if (!used[i] && !(other && geographic) && may_be_number(seen, i)) return i;
  }
  return seen.count;
}

// "say which ... with --columns lon=2,lat=1,height=3 or --columns x=2,y=1,z=3": the columns that
// the header tells, and the free ones for the rest.
std::string say_which(const Header& header, const ColumnsSeen& seen) {
  std::string text;
  for (const bool geographic : {true, false}) {
    const std::array<Role, 3> wanted =
        geographic ? std::array<Role, 3>{Role::kLongitude, Role::kLatitude, Role::kHeight}
                   : std::array<Role, 3>{Role::kX, Role::kY, Role::kZ};
    std::vector<bool> used(seen.count, false);
    for (std::size_t i = 0; i < header.words.size() && i < seen.count; ++i) {
      used[i] = header.words[i].role != Role::kNone || is_taken(seen, i);
    }
    std::vector<std::pair<Role, std::size_t>> roles;
    for (const Role role : wanted) {
      const std::size_t column = column_to_offer(role, header, seen, used);
      if (column >= seen.count) continue;
      used[column] = true;
      roles.emplace_back(role, column);
    }
    if (roles.size() < 2) continue;
    text += (text.empty() ? "say which is which, for example with " : " or ") + columns_text(roles);
  }
  if (text.empty()) {
    text =
        "needed are at least two columns of numbers, longitude and latitude or x and y, with "
        "commas, semicolons, tabs or blanks between them";
  }
  return text + " (" + list_columns(seen) + ")";
}

Error several(Role role, const Header& header, const ColumnsSeen& seen) {
  return missing("several columns look like " + std::string(role_name(role)) + "; " +
                 say_which(header, seen));
}

// Whether the column's name fits to the first coordinate's: "uav_alt" to "uav_lon", or "alt".
bool belongs_to(const HeaderWord& word, const HeaderWord& first) {
  return word.prefix.empty() || word.prefix == first.prefix;
}

// The third coordinate by its name, or the reason why it cannot be told.
Result<std::optional<std::size_t>> find_third(const Header& header, const ColumnsSeen& seen,
                                              bool geographic, const HeaderWord& first) {
  const Role first_choice = geographic ? Role::kHeight : Role::kZ;
  const Role other = geographic ? Role::kZ : Role::kHeight;
  const bool others_pair = geographic ? header.has(Role::kX) || header.has(Role::kY)
                                      : header.has(Role::kLongitude) || header.has(Role::kLatitude);
  const auto doubtful = [&](std::size_t column) {
    const std::string third = geographic ? "height" : "z";
    const std::string name = excerpt(seen.names[column]);
    if (resembles(seen.names[column], first_choice) || header.words[column].role != Role::kNone) {
      return missing("column " + name + " may or may not be the " + third + "; " +
                     say_which(header, seen));
    }
    const Role axes[] = {geographic ? Role::kLongitude : Role::kX,
                         geographic ? Role::kLatitude : Role::kY};
    return missing("no column names the " + third + ", and " + name +
                   " may or may not be it; say " +
                   columns_text({{axes[0], header.columns(axes[0]).front()},
                                 {axes[1], header.columns(axes[1]).front()}}) +
                   " if there is none, and add " + third + "=N for column N that holds it (" +
                   list_columns(seen) + ")");
  };
  for (const Role role : {first_choice, other}) {
    if (header.columns(role).size() > 1) return several(first_choice, header, seen);
    if (!header.has(role)) continue;
    const std::size_t column = header.columns(role).front();
    if (role == other && others_pair) return doubtful(column);
    if (!belongs_to(header.words[column], first)) return doubtful(column);
    return std::optional<std::size_t>(column);
  }
  for (const std::size_t column : header.columns(Role::kNone)) {
    if (is_taken(seen, column)) continue;
    const bool nameless = seen.names[column].empty() && column + 1 == seen.count;
    const ColumnContent content =
        column < seen.contents.size() ? seen.contents[column] : ColumnContent::kUnknown;
    if (content == ColumnContent::kNumber || (content == ColumnContent::kUnknown && !nameless)) {
      return doubtful(column);
    }
  }
  return std::optional<std::size_t>();
}

// How sure a header with x and y is about metres.
Naming naming_of(const HeaderWord& x, const HeaderWord& y) {
  if (x.frame != Frame::kMetres || y.frame != Frame::kMetres) return Naming::kAxes;
  return x.says_length && y.says_length ? Naming::kSure : Naming::kBareAxes;
}

Result<ColumnChoice> choose_by_names(const Header& header, const ColumnsSeen& seen,
                                     bool geographic) {
  const Role first = geographic ? Role::kLongitude : Role::kX;
  const Role second = geographic ? Role::kLatitude : Role::kY;
  for (const Role role : {first, second}) {
    if (header.columns(role).size() > 1) return several(role, header, seen);
  }
  ColumnChoice choice;
  choice.axes[0] = header.columns(first).front();
  choice.axes[1] = header.columns(second).front();
  const HeaderWord& first_word = header.words[choice.axes[0]];
  const HeaderWord& second_word = header.words[choice.axes[1]];
  if (first_word.prefix != second_word.prefix) {
    return missing("columns " + excerpt(seen.names[choice.axes[0]]) + " and " +
                   excerpt(seen.names[choice.axes[1]]) + " may not belong together; " +
                   say_which(header, seen));
  }
  const auto third = find_third(header, seen, geographic, first_word);
  if (!third) return third.error();
  choice.axes[2] = third.value().value_or(0);
  choice.dimensions = third.value().has_value() ? 3 : 2;
  choice.naming = geographic ? Naming::kSure : naming_of(first_word, second_word);
  if (choice.naming != Naming::kAxes) choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
  const bool course = first_word.course_format && second_word.course_format;
  choice.reason = course ? "the header speaks of the coordinates of bees, as the course format does"
                         : "the header names " + frame_words(geographic, third.value().has_value());
  return choice;
}

// The columns that are not known to be something else, in their order.
Result<ColumnChoice> choose_in_order(const Header& header, const ColumnsSeen& seen,
                                     std::optional<std::size_t> id, Frame frame) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < seen.count; ++i) {
    const bool named_id = i < header.words.size() && header.words[i].role == Role::kId;
    // A delimiter at the end of every line makes a nameless, empty last column.
    const bool nothing = i + 1 == seen.count && i >= 2 && i < seen.contents.size() &&
                         seen.contents[i] == ColumnContent::kUnknown && !seen.names.empty() &&
                         seen.names[i].empty();
    if (i != id && !named_id && !nothing) columns.push_back(i);
  }
  for (std::size_t i = 0; i < header.words.size(); ++i) {
    const Role role = header.words[i].role;
    const bool third = role == Role::kHeight || role == Role::kZ;
    // In metres the order of the columns changes no distance.
    const bool hint = header.words[i].says_position && frame != Frame::kMetres;
    if (role == Role::kId || (role == Role::kNone && !hint)) continue;
    if (third && columns.size() == 3 && columns[2] == i) continue;
    return missing("the header names " + excerpt(seen.names[i]) +
                   " but not the columns that belong to it; " + say_which(header, seen));
  }
  if (columns.size() != 2 && columns.size() != 3) {
    return missing(std::string(columns.size() < 2 ? "a position needs two or three columns"
                                                  : "cannot tell which columns hold the position") +
                   "; " + say_which(header, seen));
  }
  ColumnChoice choice;
  choice.naming = Naming::kNone;
  choice.dimensions = columns.size();
  std::copy(columns.begin(), columns.end(), choice.axes.begin());
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
  return choose_in_order(header, seen, id, frame);
}

// The columns, but not yet their units.
Result<ColumnChoice> find_columns(const ColumnsSeen& seen, const ColumnOptions& options) {
  std::optional<std::size_t> id;
  std::optional<ColumnChoice> wished;
  if (!options.columns.empty()) {
    const auto wishes = read_wishes(options.columns, options.frame);
    if (!wishes) return wishes.error();
    const bool only_id = wishes.value().size() == 1 && wishes.value().front().role == Role::kId;
    if (!only_id) {
      auto choice = choose_as_wished(wishes.value(), seen);
      if (!choice) return choice;
      if (choice->id) return choice;
      wished = std::move(choice).value();
    } else {
      const auto column = find_wished_column(wishes.value().front(), seen);
      if (!column) return column.error();
      id = column.value();
    }
  }
  const Header header = read_header(seen, id, options.heights);
  auto choice =
      wished ? Result<ColumnChoice>(*wished) : choose_by_header(header, seen, id, options.frame);
  if (!choice) return choice;
  std::vector<std::size_t> ids = header.columns(Role::kId);
  // Who names the coordinates may take what is called an id for one.
  const auto& axes = choice->axes;
  const auto end = axes.begin() + static_cast<std::ptrdiff_t>(choice->dimensions);
  ids.erase(std::remove_if(ids.begin(), ids.end(),
                           [&axes, end](std::size_t column) {
                             return std::find(axes.begin(), end, column) != end;
                           }),
            ids.end());
  if (!id && !ids.empty()) id = choose_id(seen, ids);
  choice->id = id;
  return choice;
}

}  // namespace

std::size_t choose_id(const ColumnsSeen& seen, const std::vector<std::size_t>& candidates) {
  const auto alone = std::find_if(
      candidates.begin(), candidates.end(),
      [&seen](std::size_t column) { return split_words(seen.names[column]).size() == 1; });
  return alone != candidates.end() ? *alone : candidates.front();
}

Result<ColumnChoice> choose_columns(const ColumnsSeen& seen, const ColumnOptions& options) {
  auto choice = find_columns(seen, options);
  if (!choice) return choice;
  if (auto problem = settle_coordinate_units(seen, options, *choice)) return *std::move(problem);
  return choice;
}

}  // namespace beespace::io
