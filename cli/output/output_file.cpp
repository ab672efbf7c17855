#include "cli/output/output_file.hpp"

#include "cli/command_line/option_values.hpp"
#include "io/recording/recording_sources.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace beespace::cli {
namespace {

// Through links of either kind; standard input may be a file, too.
bool is_same_file(const std::string& output, const std::string& input) {
  std::error_code not_there;
  return std::filesystem::equivalent(output, input == "-" ? "/dev/stdin" : input, not_there);
}

bool is_read(const std::string& output, const std::string& input) {
  if (input.empty()) return false;
  if (!io::is_folder(input)) return is_same_file(output, input);
  const auto files = io::recordings_in(input);
  return files && std::any_of(files->begin(), files->end(),
                              [&](const std::string& file) { return is_same_file(output, file); });
}

// Devices and pipes are written to, not replaced; so is standard output, whatever it is.
bool replaces_a_file(const std::string& output) {
  std::error_code not_there;
  return output != "-" && output != "/dev/stdout" &&
         std::filesystem::is_regular_file(output, not_there);
}

}  // namespace

Result<io::AtomicOutput> open_output(const char* command, const std::string& output,
                                     const std::vector<std::string>& inputs, io::Packing packing) {
  const bool replaces_an_input =
      replaces_a_file(output) &&
      std::any_of(inputs.begin(), inputs.end(),
                  [&](const std::string& input) { return is_read(output, input); });
  if (!replaces_an_input) return io::AtomicOutput::open(output, packing);
  const auto count = inputs.size() - static_cast<std::size_t>(
                                         std::count(inputs.begin(), inputs.end(), std::string()));
  return usage_error(command, "--output " + output + " is " +
                                  (count == 1 ? "the input itself" : "one of the inputs") +
                                  "; name another file");
}

}  // namespace beespace::cli
