#include "io/recording/set_names.hpp"

namespace beespace::io {

std::string_view SetNames::name_of(std::string_view id, std::string_view set) {
  // Neither has a byte 0: that is no text.
  key_.assign(id).append(1, '\0').append(set);
  const auto known = names_.find(key_);
  if (known != names_.end()) return known->second;
  std::string name(id);
  while (!taken_.insert(name).second) {
    name.append(" (").append(set.empty() ? std::string_view("none") : set).append(")");
  }
  if (name != id && told_apart_++ == 0) example_ = name;
  return names_.emplace(key_, std::move(name)).first->second;
}

}  // namespace beespace::io
