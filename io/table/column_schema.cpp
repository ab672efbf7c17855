#include "io/table/column_schema.hpp"

#include <algorithm>

namespace beespace::io {

const RoleFacts* ColumnSchema::find(Role role) const {
  const auto found = std::find_if(roles.begin(), roles.end(),
                                  [role](const RoleFacts& facts) { return facts.role == role; });
  return found == roles.end() ? nullptr : &*found;
}

const RoleFacts* ColumnSchema::find(std::string_view name) const {
  const auto found = std::find_if(roles.begin(), roles.end(),
                                  [name](const RoleFacts& facts) { return facts.name == name; });
  return found == roles.end() ? nullptr : &*found;
}

bool ColumnSchema::reads(Role role) const {
  return std::any_of(names.begin(), names.end(), [role](const NamePattern& pattern) {
    return pattern.role == role ||
           std::any_of(pattern.words.begin(), pattern.words.end(),
                       [role](const NameWords& words) { return words.role == role; });
  });
}

std::string_view ColumnSchema::whole_of(Role role) const {
  for (const RoleGroup& group : groups) {
    if (std::find(group.roles.begin(), group.roles.end(), role) != group.roles.end()) {
      return group.what;
    }
  }
  return name_of(role);
}

}  // namespace beespace::io
