#include "io/recording/names_apart.hpp"

#include "io/recording/recording_sources.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <unordered_set>

namespace beespace::io {
namespace {

using PathParts = std::vector<std::string_view>;

// Folders, archives and the file.
PathParts parts_of_path(std::string_view path) {
  PathParts parts;
  while (true) {
    const std::size_t end = path.find_first_of("/!");
    parts.push_back(path.substr(0, end));
    if (end == std::string_view::npos) return parts;
    path.remove_prefix(end + 1);
  }
}

// Or an archive.
std::string_view folder_of(std::string_view path) {
  const std::size_t end = path.find_last_of("/!");
  return end == std::string_view::npos ? std::string_view() : path.substr(0, end);
}

// How many of the parts, from the one end, are the same in all.
template <class At>
std::size_t common_parts(const std::vector<PathParts>& all, std::size_t most, const At& at) {
  std::size_t count = 0;
  const auto same = [&](const PathParts& parts) { return at(parts, count) == at(all[0], count); };
  while (count < most && std::all_of(all.begin(), all.end(), same)) ++count;
  return count;
}

}  // namespace

std::unordered_map<std::string, std::string> names_apart(const std::vector<std::string>& sources) {
  std::unordered_map<std::string, std::vector<std::size_t>> by_stem;
  for (std::size_t i = 0; i < sources.size(); ++i) by_stem[stem_of(sources[i])].push_back(i);
  std::unordered_map<std::string, std::string> names;
  std::unordered_map<std::string, std::unordered_set<std::string>> stems;  // by name
  for (const auto& [stem, same] : by_stem) {
    if (same.size() < 2) continue;
    std::vector<PathParts> all;
    std::size_t shortest = parts_of_path(sources[same[0]]).size();
    for (const std::size_t i : same) {
      all.push_back(parts_of_path(sources[i]));
      shortest = std::min(shortest, all.back().size());
    }
    const std::size_t before =
        common_parts(all, shortest, [](const PathParts& parts, std::size_t i) { return parts[i]; });
    const std::size_t behind = common_parts(
        all, shortest - before,
        [](const PathParts& parts, std::size_t i) { return parts[parts.size() - 1 - i]; });
    for (std::size_t k = 0; k < same.size(); ++k) {
      std::string name;
      for (std::size_t i = before; i + behind < all[k].size(); ++i) {
        name.append(name.empty() ? "" : "/").append(all[k][i]);
      }
      if (name.empty()) continue;
      stems[name].insert(stem);
      names.emplace(sources[same[k]], std::move(name));
    }
  }
  // Who lies beside one of these, as a second log of the same drone, is of the same.
  std::map<std::string_view, std::string> by_folder;
  for (const auto& [source, name] : names) {
    std::string& of = by_folder[folder_of(source)];
    if (of.empty() || name < of) of = name;
  }
  for (const std::string& source : sources) {
    const auto beside = by_folder.find(folder_of(source));
    if (names.contains(source) || beside == by_folder.end()) continue;
    stems[beside->second].insert(stem_of(source));
    names.emplace(source, beside->second);
  }
  // Folders that hold several each: which of them is said, too.
  for (auto& [source, name] : names) {
    if (stems[name].size() > 1) name += "/" + stem_of(source);
  }
  return names;
}

}  // namespace beespace::io
