#include "io/recording/file_names.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_set>

namespace beespace::io {
namespace {

void replace_all(std::string& text, const std::string& name, const std::string& by) {
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + by.size())) {
    text.replace(at, name.size(), by);
  }
}

}  // namespace

std::string_view FileNames::name_of(std::string_view file, std::string_view id) {
  key_.assign(file).append(1, ':').append(id);
  return ids_.try_emplace(key_, id).first->first;
}

void FileNames::shorten(Recording& recording) const {
  std::unordered_set<std::string_view> taken;
  for (const auto& [name, id] : ids_) {
    if (id.empty() || !taken.insert(id).second) return;
  }
  for (const RecordedBee& bee : recording.bees) {
    if (!ids_.contains(bee.id) && !taken.insert(bee.id).second) return;
  }
  const auto rename = [this](std::string& name) {
    const auto known = ids_.find(name);
    if (known != ids_.end()) name = known->second;
  };
  for (RecordedBee& bee : recording.bees) rename(bee.id);
  MissingRecords& missing = recording.missing;
  for (auto* const names : {&missing.nowhere_ids, &missing.shared_ids, &missing.jumping_ids}) {
    std::for_each(names->begin(), names->end(), rename);
  }
  for (std::string& note : recording.notes) {
    for (const auto& [name, id] : ids_) replace_all(note, name, id);
  }
}

}  // namespace beespace::io
