// What standard error is connected to, and words on it.
#pragma once

#include <string>
#include <string_view>

namespace beespace::cli {

bool input_is_terminal();
bool output_is_terminal();
bool messages_are_on_terminal();

// A terminal, and neither NO_COLOR set (no-color.org) nor TERM "dumb".
bool messages_may_have_colour();

// The text, bold or red where colour is welcome.
std::string bold(std::string_view text);
std::string red(std::string_view text);

// The text without the control characters by which a file could play tricks on a terminal.
std::string printable(std::string_view text);

// To standard error, whole; a closed standard error is no problem.
void say(std::string_view text);

// "beespace: error: ...".
void say_error(std::string_view message);

}  // namespace beespace::cli
