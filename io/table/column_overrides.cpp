#include "io/table/column_overrides.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/record_problems.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace beespace::io {
namespace {

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, "--columns: " + std::move(message), {}};
}

// "lon, lat and height"; the first `count` of them.
std::string names_of(const ColumnSchema& schema, const RoleGroup& group, std::size_t count,
                     std::string_view last = ", ") {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text.append(i == 0 ? "" : i + 1 == count ? last : ", ").append(schema.name_of(group.roles[i]));
  }
  return text;
}

Error not_understood(const ColumnSchema& schema, std::string_view item, bool last) {
  std::string text = excerpt(item) + " is not understood; ";
  if (last && item.empty()) return invalid(text + "there is a comma at the end; remove it");
  text += "write role=column, where the role is ";
  for (std::size_t i = 0; i < schema.roles.size(); ++i) {
    const bool final = i + 1 == schema.roles.size();
    text.append(i == 0 ? "" : final ? " or " : ", ").append(schema.roles[i].name);
  }
  return invalid(text + " and the column a number (from 1) or a name");
}

Result<std::vector<ColumnOverride>> parse(const ColumnSchema& schema, std::string_view text) {
  std::vector<ColumnOverride> overrides;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const bool last = comma == std::string_view::npos;
    const std::size_t equals = std::min(item.find('='), item.size());
    const RoleFacts* const facts = schema.find(without_padding(item.substr(0, equals)));
    const auto column = without_padding(item.substr(std::min(equals + 1, item.size())));
    if (facts == nullptr || column.empty()) return not_understood(schema, item, last);
    const auto again = std::find_if(overrides.begin(), overrides.end(),
                                    [&](const auto& other) { return other.role == facts->role; });
    if (again != overrides.end()) {
      return invalid(std::string(facts->name) + " is given twice; keep one");
    }
    overrides.push_back({facts->role, facts->name, std::string(column)});
    if (last) return overrides;
    text.remove_prefix(comma + 1);
  }
}

// What no file can fulfil.
std::optional<Error> problem_of(const ColumnSchema& schema,
                                const std::vector<ColumnOverride>& overrides, Frame frame) {
  const auto has = [&overrides](Role role) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [role](const ColumnOverride& one) { return one.role == role; });
  };
  const RoleGroup* before = nullptr;
  for (const RoleGroup& group : schema.groups) {
    const auto [first, second, third] = group.roles;
    if (!has(first) && !has(second) && !has(third)) continue;
    if (before != nullptr && before->what == group.what) {
      return invalid(names_of(schema, *before, 3) + " and " + names_of(schema, group, 3) +
                     " do not go together; use one set");
    }
    before = &group;
  }
  for (const RoleGroup& group : schema.groups) {
    const auto [first, second, third] = group.roles;
    if (!has(first) && !has(second) && !has(third)) continue;
    if (!has(first) || !has(second)) {
      if (!group.needs.empty()) return invalid(std::string(group.needs));
      const Role there = has(first) ? first : has(second) ? second : third;
      return invalid(std::string(schema.name_of(there)) + " needs " +
                     (has(first)    ? std::string(schema.name_of(second))
                      : has(second) ? std::string(schema.name_of(first))
                                    : names_of(schema, group, 2, " and ")) +
                     " too");
    }
    if (frame == Frame::kAuto || group.frame == Frame::kAuto || group.frame == frame) continue;
    return invalid(names_of(schema, group, 3, " and ") +
                   (group.frame == Frame::kWgs84 ? " are in degrees, but --crs metres"
                                                 : " are in metres, but --crs wgs84") +
                   " is given too; keep one of them");
  }
  return std::nullopt;
}

// The only column for which `same` holds; nothing when there is none.
template <typename Same>
Result<std::optional<std::size_t>> only_column(const ColumnOverride& wanted,
                                               const TableLayout& table, const Same& same) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (!same(table.names[i])) continue;
    if (found) {
      const auto choice = [&wanted](std::size_t column) {
        return std::string(wanted.name).append("=").append(std::to_string(column + 1));
      };
      std::string text = "columns " + std::to_string(*found + 1);
      text.append(" and ").append(std::to_string(i + 1)).append(" are both named ");
      text.append(excerpt(wanted.column)).append("; give the number: ");
      return missing_column(text.append(choice(*found)).append(" or ").append(choice(i)));
    }
    found = i;
  }
  return found;
}

Result<std::size_t> find_column(const ColumnOverride& wanted, const TableLayout& table) {
  std::size_t number = 0;
  const std::string& text = wanted.column;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (parsed.ptr == end) {
    if (parsed.ec == std::errc() && number >= 1 && number <= table.columns) return number - 1;
    return missing_column("there is no column " + text + "; " + list_columns(table));
  }
  const auto exact =
      only_column(wanted, table, [&text](const std::string& name) { return name == text; });
  if (!exact) return exact.error();
  if (exact.value()) return *exact.value();
  const auto near = only_column(wanted, table, [lower = lower_case(text)](const std::string& name) {
    return lower_case(name) == lower;
  });
  if (!near) return near.error();
  if (near.value()) return *near.value();
  return missing_column("there is no column named " + excerpt(text) + "; " + list_columns(table));
}

// A column whose name says that it holds degrees is not taken for metres, unless --crs says so.
std::optional<Error> degrees_as_metres(const ColumnSchema& schema, const TableLayout& table,
                                       const ColumnsByRole& columns) {
  for (const auto& [axis, degrees] :
       {std::pair(Role::kX, Role::kLongitude), std::pair(Role::kX, Role::kLatitude),
        std::pair(Role::kY, Role::kLongitude), std::pair(Role::kY, Role::kLatitude)}) {
    const auto column = columns[index_of(axis)];
    if (!column || *column >= table.names.size()) continue;
    const std::string& name = table.names[*column];
    const RoleFacts* const facts = schema.find(degrees);
    if (facts == nullptr || read_column_name(schema, name).role != degrees) continue;
    const std::vector<std::string> words = split_words(name);
    if (std::none_of(words.begin(), words.end(), [facts](const std::string& word) {
          return is_one_of(facts->resembling, word);
        })) {
      continue;
    }
    return invalid(std::string(schema.name_of(axis)) + " is in metres, but " +
                   column_text(table, *column) + " is a " +
                   (degrees == Role::kLongitude ? "longitude" : "latitude") +
                   "; write lon=...,lat=... for degrees, or say --crs metres if these are lengths");
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<ColumnOverride>> read_column_overrides(const ColumnSchema& schema,
                                                          std::string_view text, Frame frame) {
  if (text.empty()) return std::vector<ColumnOverride>();
  if (is_blank_line(text)) {
    return invalid("it is empty; write lon=1,lat=2,height=3 or x=1,y=2,z=3, or leave it out");
  }
  auto overrides = parse(schema, text);
  if (!overrides) return overrides;
  if (auto problem = problem_of(schema, *overrides, frame)) return *std::move(problem);
  return overrides;
}

Result<ColumnsByRole> find_overrides(const ColumnSchema& schema, const ColumnOptions& options,
                                     const TableLayout& table) {
  const auto overrides = read_column_overrides(schema, options.columns, options.frame);
  if (!overrides) return overrides.error();
  ColumnsByRole columns = {};
  for (const ColumnOverride& wanted : *overrides) {
    const auto column = find_column(wanted, table);
    if (!column) return column.error();
    columns[index_of(wanted.role)] = *column;
  }
  if (auto problem = doubly_used(schema, columns)) return *std::move(problem);
  if (options.frame == Frame::kAuto) {
    if (auto problem = degrees_as_metres(schema, table, columns)) return *std::move(problem);
  }
  return columns;
}

std::optional<Error> doubly_used(const ColumnSchema& schema, const ColumnsByRole& columns) {
  for (std::size_t i = 0; i < kRoles; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto one = static_cast<Role>(j);
      const auto other = static_cast<Role>(i);
      if (!columns[i] || columns[i] != columns[j] || one == Role::kId || other == Role::kId) {
        continue;
      }
      const bool together = schema.whole_of(one) == schema.whole_of(other);
      return invalid("column " + std::to_string(*columns[i] + 1) + " cannot be both " +
                     std::string(together ? schema.name_of(one) : schema.whole_of(one)) + " and " +
                     std::string(together ? schema.name_of(other) : schema.whole_of(other)));
    }
  }
  return std::nullopt;
}

std::string list_columns(const TableLayout& table) {
  constexpr std::size_t kMostListed = 20;
  if (table.names.empty()) {
    return table.columns == 1
               ? "there is 1 column and no header"
               : "there are " + std::to_string(table.columns) + " columns and no header";
  }
  std::string text = "the columns are";
  for (std::size_t i = 0; i < table.names.size() && i < kMostListed; ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(i + 1) + " " + excerpt(table.names[i]);
  }
  return text + (table.names.size() > kMostListed ? ", ..." : "");
}

std::string column_text(const TableLayout& table, std::size_t column) {
  std::string text = "column " + std::to_string(column + 1);
  if (column < table.names.size()) text.append(" ").append(excerpt(table.names[column]));
  return text;
}

}  // namespace beespace::io
