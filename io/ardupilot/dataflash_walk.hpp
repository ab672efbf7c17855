// A walk over the messages of a DataFlash log of ArduPilot (.bin), and what was lost on the way.
//
// A log has no checksums. What is no message of a type that it has defined is passed over until the
// next one behind which another one begins, and counted.
#pragma once

#include "io/ardupilot/dataflash_format.hpp"
#include "io/flight_logs/log_losses.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// By the first bytes, which define what a definition is.
bool is_dataflash_log(std::string_view bytes);

class DataflashWalk {
 public:
  // `bytes` begin as is_dataflash_log() says.
  explicit DataflashWalk(std::string_view bytes);

  // To the next message that is no definition; false when there is none.
  bool next();

  // Of the message: how it is laid out, and what it says, without its front.
  [[nodiscard]] const DataflashLayout& layout() const { return *layout_; }
  [[nodiscard]] std::string_view message() const { return message_; }
  // So far.
  [[nodiscard]] const LogLosses& losses() const { return losses_; }

 private:
  [[nodiscard]] const DataflashLayout* layout_at(std::size_t at) const;
  [[nodiscard]] bool is_front(std::size_t at) const;
  [[nodiscard]] bool is_sure(std::size_t at) const;
  [[nodiscard]] bool is_unwritten(std::size_t at) const;
  bool pass_damage();

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::array<std::optional<DataflashLayout>, 256> layouts_ = {};  // by type
  const DataflashLayout* layout_ = nullptr;
  std::string_view message_ = {};
  LogLosses losses_;
};

}  // namespace beespace::io
