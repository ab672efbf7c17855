#include "cli/console/terminal.hpp"

#include <unistd.h>
#include <cstddef>
#include <cstdlib>

namespace beespace::cli {
namespace {

std::string with_style(std::string_view style, std::string_view text) {
  if (!messages_may_have_colour()) return std::string(text);
  return "\x1b[" + std::string(style) + "m" + std::string(text) + "\x1b[0m";
}

}  // namespace

bool input_is_terminal() {
  return isatty(STDIN_FILENO) == 1;
}

bool output_is_terminal() {
  return isatty(STDOUT_FILENO) == 1;
}

bool messages_are_on_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

bool messages_may_have_colour() {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  const bool refused = no_colour != nullptr && *no_colour != '\0';
  const bool dumb = kind == nullptr || std::string_view(kind) == "dumb";
  return messages_are_on_terminal() && !refused && !dumb;
}

std::string bold(std::string_view text) {
  return with_style("1", text);
}

std::string red(std::string_view text) {
  return with_style("1;31", text);
}

std::string printable(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto byte = static_cast<unsigned char>(out[i]);
    const auto next = static_cast<unsigned char>(i + 1 < out.size() ? out[i + 1] : 0);
    const bool upper_control = byte == 0xC2 && next >= 0x80 && next < 0xA0;  // U+0080 to U+009F
    if (byte < 0x20 || byte == 0x7F || upper_control) out[i] = '?';
    if (upper_control) out[i + 1] = '?';
  }
  return out;
}

void say(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void say_error(std::string_view message) {
  std::string line = "beespace: " + red("error:") + " ";
  line += message;
  line += '\n';
  say(line);
}

}  // namespace beespace::cli
