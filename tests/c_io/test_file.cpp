#include "tests/c_io/test_file.hpp"

#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <stdlib.h>

namespace beespace::test {

TestFolder::TestFolder() : path_(std::filesystem::temp_directory_path() / "beespace-XXXXXX") {
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no folder for the test");
}

TestFolder::~TestFolder() {
  std::error_code left_behind;
  std::filesystem::remove_all(path_, left_behind);
}

std::string TestFolder::file(const std::string& name, std::string_view content) const {
  std::ofstream file(path(name), std::ios::binary);
  file << content;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path(name));
  return path(name);
}

std::string TestFolder::gzip_file(const std::string& name, std::string_view content) const {
  gzFile file = gzopen(path(name).c_str(), "wb");
  const auto size = static_cast<unsigned>(content.size());
  if (file == nullptr || gzwrite(file, content.data(), size) != static_cast<int>(size) ||
      gzclose(file) != Z_OK) {
    throw std::runtime_error("cannot write " + path(name));
  }
  return path(name);
}

}  // namespace beespace::test
