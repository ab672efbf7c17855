// Where temporary files go.
#pragma once

#include <cstdlib>
#include <string>

namespace beespace::cli {

// The folder that was said with --temporary, or that of the environment.
inline std::string temporary_folder(const std::string& said) {
  if (!said.empty()) return said;
  const char* const usual = std::getenv("TMPDIR");
  return usual != nullptr && *usual != '\0' ? usual : "/var/tmp";
}

}  // namespace beespace::cli
