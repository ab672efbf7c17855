// What a log that a drone wrote has lost: it has no checksums, so that what is no message of it is
// passed over, and counted.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct LogLosses {
  std::uint64_t damaged_places = 0;
  std::uint64_t damaged_bytes = 0;
  std::size_t first_damage = 0;            // where, where there is any
  std::optional<std::size_t> cut_at = {};  // the last message begins there, and is not all there
};

// Says them, and counts them as records of that bee that are missing.
void tell_losses(const LogLosses& losses, std::string_view id, RecordingAssembly& assembly);

// What to say of them where nothing could be read: "; it is damaged from byte 8 on", or nothing.
std::string words_of(const LogLosses& losses);

}  // namespace beespace::io
