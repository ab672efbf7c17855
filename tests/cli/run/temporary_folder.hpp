// A folder of its own for one test, removed with everything in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli_test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return path_ + "/" + name; }
  // Writes a file and returns its path.
  std::string file(const std::string& name, std::string_view content) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  // The names in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::string path_;
};

}  // namespace beespace::cli_test
