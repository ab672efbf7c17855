#include "io/table/column_choice.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/header_words.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::array<Role, 3> kGeographic = {Role::kLongitude, Role::kLatitude, Role::kHeight};
constexpr std::array<Role, 3> kMetric = {Role::kX, Role::kY, Role::kZ};

// "--columns lon=2,lat=1"
std::string columns_text(const Header& header,
                         const std::vector<std::pair<Role, std::size_t>>& roles) {
  std::string text = "--columns ";
  for (std::size_t i = 0; i < roles.size(); ++i) {
    text.append(i == 0 ? "" : ",").append(header.schema().name_of(roles[i].first)).append("=");
    text += std::to_string(roles[i].second + 1);
  }
  return text;
}

std::string frame_words(bool geographic, bool third) {
  if (geographic) return third ? "longitude, latitude and height" : "longitude and latitude";
  return third ? "x, y and z" : "x and y";
}

// Whether a column may hold numbers, as far as was looked.
bool may_be_number(const TableLayout& table, std::size_t column) {
  return column >= table.contents.size() || table.contents[column] != ColumnContent::kText;
}

// The column to offer for a role: by its name, or else the first that is free.
std::size_t column_to_offer(Role role, const Header& header, const std::vector<bool>& used) {
  const TableLayout& table = header.table();
  const auto like = [&header, &table](std::size_t column, Role of) {
    return resembles(header.schema(), table.names[column], of);
  };
  if (header.has(role)) return header.columns(role).front();
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!used[i] && like(i, role)) return i;
  }
  // Beside two that have names a third is not just any column.
  const bool geographic = role == Role::kLongitude || role == Role::kLatitude;
  const bool third = role == Role::kHeight || role == Role::kZ;
  const auto& axes = role == Role::kHeight ? kGeographic : kMetric;
  if (third && header.has(axes[0]) && header.has(axes[1])) return table.columns;
  for (std::size_t i = 0; i < table.columns; ++i) {
    const bool other = i < header.size() && (like(i, Role::kLongitude) || like(i, Role::kLatitude));
    if (!used[i] && !(other && geographic) && may_be_number(table, i)) return i;
  }
  return table.columns;
}

// "say which ... with --columns lon=2,lat=1,height=3 or --columns x=2,y=1,z=3": the columns that
// the header tells, and the free ones for the rest.
std::string say_which(const Header& header) {
  std::string text;
  for (const auto& wanted : {kGeographic, kMetric}) {
    std::vector<bool> used(header.table().columns, false);
    for (std::size_t i = 0; i < header.size() && i < used.size(); ++i) {
      used[i] = header.meaning(i).role != Role::kNone;
    }
    std::vector<std::pair<Role, std::size_t>> roles;
    for (const Role role : wanted) {
      if (header.schema().find(role) == nullptr) continue;
      const std::size_t column = column_to_offer(role, header, used);
      if (column >= used.size()) continue;
      used[column] = true;
      roles.emplace_back(role, column);
    }
    if (roles.size() < 2) continue;
    text += (text.empty() ? "say which is which, for example with " : " or ") +
            columns_text(header, roles);
  }
  if (text.empty()) {
    text =
        "needed are at least two columns of numbers, longitude and latitude or x and y, with "
        "commas, semicolons, tabs or blanks between them";
  }
  return text + " (" + list_columns(header.table()) + ")";
}

Error several(Role role, const Header& header) {
  return missing_column("several columns look like " + std::string(header.schema().name_of(role)) +
                        "; " + say_which(header));
}

// The third coordinate by its name, or the reason why it cannot be told.
Result<std::optional<std::size_t>> find_third(const Header& header, bool geographic,
                                              const ColumnMeaning& first) {
  const TableLayout& table = header.table();
  const auto& axes = geographic ? kGeographic : kMetric;
  const auto& others = geographic ? kMetric : kGeographic;
  const auto doubtful = [&](std::size_t column) {
    const std::string third(header.schema().name_of(axes[2]));
    const std::string name = excerpt(table.names[column]);
    if (counts_from_takeoff(table.names[column])) {
      return missing_column(
          "column " + name +
          " counts from where each one took off, or from the ground, so that heights of several "
          "cannot be compared; take heights above sea level, or, if all took off at one height, "
          "say " +
          columns_text(header, {{axes[0], header.columns(axes[0]).front()},
                                {axes[1], header.columns(axes[1]).front()},
                                {axes[2], column}}) +
          (geographic ? " --crs wgs84" : " --crs metres") + " (" + list_columns(table) + ")");
    }
    if (resembles(header.schema(), table.names[column], axes[2]) ||
        header.meaning(column).role != Role::kNone) {
      return missing_column("column " + name + " may or may not be the " + third + "; " +
                            say_which(header));
    }
    return missing_column("no column names the " + third + ", and " + name +
                          " may or may not be it; say " +
                          columns_text(header, {{axes[0], header.columns(axes[0]).front()},
                                                {axes[1], header.columns(axes[1]).front()}}) +
                          " if there is none, and add " + third +
                          "=N for column N that holds it (" + list_columns(table) + ")");
  };
  for (const Role role : {axes[2], others[2]}) {
    if (header.columns(role).size() > 1) return several(axes[2], header);
    if (!header.has(role)) continue;
    const std::size_t column = header.columns(role).front();
    const bool others_pair = header.has(others[0]) || header.has(others[1]);
    if (role == others[2] && others_pair) return doubtful(column);
    // "uav_alt" fits to "uav_lon", and so does "alt".
    const std::string& prefix = header.meaning(column).prefix;
    if (!prefix.empty() && prefix != first.prefix) return doubtful(column);
    return std::optional<std::size_t>(column);
  }
  for (const std::size_t column : header.columns(Role::kNone)) {
    if (header.source() != nullptr && header.source()->of_animals) break;
    const std::string& name = table.names[column];
    if (names_other_quantity(name) || names_set(name) || names_session(name)) continue;
    if (names_scene(name)) continue;
    // Of a picture beside the time; where no time is read, the table may be a recording.
    if (header.schema().reads(Role::kTime) &&
        is_one_of("frame frame_id frame_idx", plain_name(name)))
      continue;
    if (counts_from_takeoff(name)) return doubtful(column);
    if (names_zone(name)) continue;  // whether all are of one is asked of records
    const bool nameless = table.names[column].empty() && column + 1 == table.columns;
    // Rows are numbered there, as R and pandas write tables.
    if (table.names[column].empty() && column == 0) continue;
    const ColumnContent content =
        column < table.contents.size() ? table.contents[column] : ColumnContent::kUnknown;
    if (content == ColumnContent::kNumber || (content == ColumnContent::kUnknown && !nameless)) {
      return doubtful(column);
    }
  }
  return std::optional<std::size_t>();
}

// How sure a header with x and y is about metres.
Naming naming_of(const ColumnMeaning& x, const ColumnMeaning& y) {
  if (x.frame != Frame::kMetres || y.frame != Frame::kMetres) return Naming::kAxes;
  return x.says_length && y.says_length ? Naming::kSure : Naming::kBareAxes;
}

Result<ColumnChoice> choose_by_names(const Header& header, bool geographic) {
  const TableLayout& table = header.table();
  const auto& axes = geographic ? kGeographic : kMetric;
  for (const Role role : {axes[0], axes[1]}) {
    if (header.columns(role).size() > 1) return several(role, header);
  }
  ColumnChoice choice;
  choice.axes[0] = header.columns(axes[0]).front();
  choice.axes[1] = header.columns(axes[1]).front();
  const ColumnMeaning& first = header.meaning(choice.axes[0]);
  const ColumnMeaning& second = header.meaning(choice.axes[1]);
  if (first.prefix != second.prefix) {
    return missing_column("columns " + excerpt(table.names[choice.axes[0]]) + " and " +
                          excerpt(table.names[choice.axes[1]]) + " may not belong together; " +
                          say_which(header));
  }
  const auto third = find_third(header, geographic, first);
  if (!third) return third.error();
  choice.axes[2] = third.value().value_or(0);
  choice.dimensions = third.value().has_value() ? 3 : 2;
  choice.naming = geographic ? Naming::kSure : naming_of(first, second);
  if (choice.naming != Naming::kAxes) choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
  choice.reason = first.course_format && second.course_format
                      ? "the header speaks of the coordinates of bees, as the course format does"
                      : "the header names " + frame_words(geographic, choice.dimensions == 3);
  return choice;
}

// The columns that are not known to be something else, in their order.
Result<ColumnChoice> choose_in_order(const Header& header) {
  const TableLayout& table = header.table();
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns; ++i) {
    const bool id = i == header.override_of(Role::kId) ||
                    (i < header.size() && header.meaning(i).role == Role::kId);
    // A delimiter at the end of every line makes a nameless, empty last column.
    const bool nothing = i + 1 == table.columns && i >= 2 && i < table.contents.size() &&
                         table.contents[i] == ColumnContent::kUnknown && i < header.size() &&
                         table.names[i].empty();
    if (!id && !nothing) columns.push_back(i);
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    const Role role = header.meaning(i).role;
    const bool third = role == Role::kHeight || role == Role::kZ;
    // In metres the order of the columns changes no distance.
    const bool hint = header.meaning(i).says_position && header.options().frame != Frame::kMetres;
    if (role == Role::kId || (role == Role::kNone && !hint)) continue;
    if (third && columns.size() == 3 && columns[2] == i) continue;
    return missing_column("the header names " + excerpt(table.names[i]) +
                          " but not the columns that belong to it; " + say_which(header));
  }
  if (columns.size() != 2 && columns.size() != 3) {
    return missing_column(std::string(columns.size() < 2
                                          ? "a position needs two or three columns"
                                          : "cannot tell which columns hold the position") +
                          "; " + say_which(header));
  }
  ColumnChoice choice;
  choice.naming = Naming::kNone;
  choice.dimensions = columns.size();
  std::copy(columns.begin(), columns.end(), choice.axes.begin());
  return choice;
}

// "ECEF_X [m]"
bool are_of_the_earth(const Header& header) {
  const auto is_of_the_earth = [&header](Role role) {
    const std::vector<std::string> words =
        split_words(header.table().names[header.columns(role).front()]);
    return std::find(words.begin(), words.end(), "ecef") != words.end();
  };
  return is_of_the_earth(Role::kX) && is_of_the_earth(Role::kY);
}

Result<ColumnChoice> choose_by_header(const Header& header) {
  const Frame frame = header.options().frame;
  const bool geographic = header.has(Role::kLongitude) && header.has(Role::kLatitude);
  const bool metres = header.has(Role::kX) && header.has(Role::kY);
  // Tables of animals have the same place in both, and so have those of traffic, which projects it
  // (compute_xy), and those with x, y, z of the Earth; the x, y of QGroundControl count from where
  // each vehicle was switched on.
  const TableSource* const source = header.source();
  const bool both = (source != nullptr && (source->of_animals || source->name == kTraffic ||
                                           source->name == kQGroundControl)) ||
                    (metres && are_of_the_earth(header));
  if (geographic && metres && frame == Frame::kAuto && !both) {
    return missing_column(
        "the header names both longitude, latitude and x, y; say which to take with --crs wgs84 "
        "or --crs metres");
  }
  if (geographic && (!metres || frame == Frame::kWgs84 || (both && frame == Frame::kAuto))) {
    return choose_by_names(header, true);
  }
  if (metres) return choose_by_names(header, false);
  return choose_in_order(header);
}

// As the caller says; nothing where the caller does not.
std::optional<ColumnChoice> overridden_position(const ColumnsByRole& overrides) {
  for (const bool geographic : {true, false}) {
    const auto& axes = geographic ? kGeographic : kMetric;
    if (!overrides[index_of(axes[0])]) continue;
    const auto third = overrides[index_of(axes[2])];
    ColumnChoice choice;
    choice.axes = {*overrides[index_of(axes[0])], *overrides[index_of(axes[1])], third.value_or(0)};
    choice.dimensions = third ? 3 : 2;
    choice.evidence = geographic ? Frame::kWgs84 : Frame::kMetres;
    choice.reason = "--columns names " + frame_words(geographic, third.has_value());
    return choice;
  }
  return std::nullopt;
}

}  // namespace

std::size_t choose_id(const TableLayout& table, const std::vector<std::size_t>& candidates) {
  // What is called by a name is also called so by others: "Device Name" beside "Device ID".
  std::vector<std::size_t> unnamed = candidates;
  std::erase_if(unnamed, [&table](std::size_t column) {
    const std::vector<std::string> words = split_words(table.names[column]);
    return !words.empty() && is_one_of("name label nombre nom", words.back());
  });
  if (unnamed.empty()) unnamed = candidates;
  std::vector<std::size_t> alone;
  for (const std::size_t column : unnamed) {
    if (split_words(table.names[column]).size() == 1) alone.push_back(column);
  }
  if (alone.empty()) return unnamed.front();
  // An aircraft has one address and flies as many.
  const auto lasting = std::find_if(alone.begin(), alone.end(), [&table](std::size_t column) {
    return lower_case(without_padding(table.names[column])) != "callsign";
  });
  return lasting != alone.end() ? *lasting : alone.front();
}

bool resembles(const ColumnSchema& schema, const std::string& name, Role role) {
  const RoleFacts* const facts = schema.find(role);
  return facts != nullptr && is_one_of(facts->resembling, lower_case(name));
}

Result<ColumnChoice> choose_position(const Header& header) {
  auto overridden = overridden_position(header.overrides());
  auto choice =
      overridden ? Result<ColumnChoice>(*std::move(overridden)) : choose_by_header(header);
  if (!choice) return choice;
  if (auto problem =
          settle_coordinate_units(header.schema(), header.table(), header.options(), *choice)) {
    return *std::move(problem);
  }
  return choice;
}

Result<ColumnChoice> choose_columns(const TableLayout& table, const ColumnOptions& options) {
  return choose_columns(table, options, position_columns());
}

Result<ColumnChoice> choose_columns(const TableLayout& table, const ColumnOptions& options,
                                    const ColumnSchema& schema) {
  const auto overrides = find_overrides(schema, options, table);
  if (!overrides) return overrides.error();
  const Header header(schema, options, table, *overrides);
  auto choice = choose_position(header);
  if (!choice) return choice;
  choice->id = header.override_of(Role::kId);
  if (choice->id) return choice;
  // The caller may take what is called an id for a coordinate.
  std::vector<std::size_t> ids;
  const auto end = choice->axes.begin() + static_cast<std::ptrdiff_t>(choice->dimensions);
  for (const std::size_t column : header.columns(Role::kId)) {
    if (std::find(choice->axes.begin(), end, column) == end) ids.push_back(column);
  }
  if (!ids.empty()) choice->id = choose_id(table, ids);
  return choice;
}

}  // namespace beespace::io
