// The definitions of a DataFlash log of ArduPilot: what the messages of a type hold, and where.
// Source: ardupilot.org, "Code Overview: Adding a New Log Message".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct DataflashField {
  std::string label;
  char type = 'B';         // a letter of the log
  std::size_t offset = 0;  // in the message, behind its front
};

struct DataflashLayout {
  std::string name;
  std::vector<DataflashField> fields;  // none where the definition contradicts itself
  std::size_t size = 0;                // of a message, with its front

  // Null where there is none.
  [[nodiscard]] const DataflashField* field(std::string_view label) const;
};

// Two bytes that each message begins with, and its type.
inline constexpr std::size_t kDataflashFront = 3;

// What a definition says behind its front: a type, a length, a name, the letters of its fields and
// their labels. Nothing where no message can be that short.
std::optional<DataflashLayout> dataflash_layout(std::string_view definition);

// Of a field of this layout's messages, in the unit that its letter means: degrees, or hundredths
// made whole. Nothing of text and arrays. `message` is without its front.
std::optional<double> dataflash_number(std::string_view message, const DataflashField& field);
// Of text; empty of numbers.
std::string_view dataflash_text(std::string_view message, const DataflashField& field);

}  // namespace beespace::io
