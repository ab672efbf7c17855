// A text for each of many points, which waits in a temporary file: an id, or a whole record.
#pragma once

#include "io/bytes/scratch_file.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// Memory: an eighth of a byte a point, and what finish() allows. The first error is kept, and all
// that comes later does nothing.
class TextStore {
 public:
  explicit TextStore(std::string folder) : folder_(std::move(folder)) {}

  // Of the next point.
  void add(std::string_view text);
  // All were added; from now on they may be asked for, with so much memory or little more.
  void finish(std::size_t memory_bytes);

  // Until the next call. Empty where something went wrong.
  std::string_view text(LargeId point);

  // Errors: those of ScratchFile.
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  static constexpr std::size_t kPointsInBlock = 128;

  // A block as it was read.
  struct Kept {
    std::size_t number = std::numeric_limits<std::size_t>::max();
    std::vector<char> bytes;
  };

  void write_block();
  const Kept* block(std::size_t number);

  std::string folder_;
  std::optional<io::ScratchFile> file_;
  std::vector<io::ScratchFile::Block> blocks_;
  std::vector<std::uint32_t> ends_;  // of the texts of the block that grows
  std::string texts_;                // one after the other
  std::vector<Kept> kept_;           // by the number of the block, modulo
  Status status_ = std::monostate{};
};

}  // namespace beespace::cli
