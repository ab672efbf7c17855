// Files that are no text, by their first bytes: the one place that knows what they are, and what to
// type so that beespace can read what is in them.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// "a PDF document; export the table as CSV"; empty where the bytes begin as no file that is known.
std::string words_of_signature(std::string_view bytes);

// Whether it is a file of other programs, which nothing here reads whatever it is called.
bool is_foreign_file(std::string_view bytes);

// What is said of a zip archive of other programs, by what is in it; nothing of others.
std::string words_of_zip(std::string_view bytes);

// The same of a folder that ROS 2 recorded into, which is FILE in it.
std::string words_of_bag_folder();

}  // namespace beespace::io
