#include "io/recording_sources.hpp"

#include "io/header_words.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace beespace::io {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return path != "-" && std::filesystem::is_directory(path, ignored);
}

bool is_table_name(std::string_view name) {
  const std::string lower = lower_case(name);
  std::string_view rest = lower;
  if (ends_with(rest, ".gz")) rest.remove_suffix(3);
  return ends_with(rest, ".csv") || ends_with(rest, ".tsv") || ends_with(rest, ".txt");
}

Result<std::vector<std::string>> tables_in(const std::string& folder) {
  std::vector<std::string> tables;
  std::error_code problem;
  std::filesystem::directory_iterator entry(folder, problem);
  for (; !problem && entry != std::filesystem::directory_iterator(); entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    if (name.front() == '.' || !is_table_name(name) || is_folder(entry->path().string())) continue;
    tables.push_back(entry->path().string());
  }
  if (problem) {
    return Error{ErrorCode::kCannotOpen,
                 "cannot read this folder: " + problem.message() + "; check its permissions",
                 {folder}};
  }
  if (tables.empty()) {
    return Error{ErrorCode::kNoPoints,
                 "there is no .csv, .tsv or .txt file in this folder; name the files, or the "
                 "folder that holds them",
                 {folder}};
  }
  std::sort(tables.begin(), tables.end());
  return tables;
}

std::string stem_of(std::string_view path) {
  if (path == "-") return "stdin";
  const std::size_t slash = path.rfind('/');
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  std::string_view stem = path;
  if (ends_with(lower_case(stem), ".gz")) stem.remove_suffix(3);
  const std::size_t dot = stem.rfind('.');
  if (dot != std::string_view::npos && dot > 0) stem = stem.substr(0, dot);
  return std::string(stem.empty() ? path : stem);
}

}  // namespace beespace::io
