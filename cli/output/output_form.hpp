// Which form an answer is in: by how the name of its file ends, or by --csv, --json and --geojson.
// One rule for all subcommands.
#pragma once

#include "io/bytes/atomic_output.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

struct FileEnding {
  std::string ending;       // "svg" of "out/Bees.SVG", "csv" of "bees.csv.gz"; empty: none
  bool compressed = false;  // .gz stands behind it
};
FileEnding file_ending(std::string_view name);

enum class Form : std::uint8_t { kText, kCsv, kJson, kGeoJson };

// What a subcommand can write.
struct WrittenForms {
  std::vector<Form> forms;
  // Beside .txt, which any form may be called: the endings of its plain text.
  std::vector<std::string> text_endings = {"tsv"};
};

// As typed.
struct AskedForm {
  const std::string& output;
  bool csv = false;
  bool json = false;
  bool geojson = false;
};

struct OutputForm {
  Form form = Form::kText;
  io::Packing packing = io::Packing::kPlain;
};

// The ending decides; where there is none, as of standard output, or .txt, the option does; without
// one it is text, or the first of the forms where there is no text. Errors: kInvalidArgument for
// two options, an ending that is not written, and one that contradicts the option.
Result<OutputForm> output_form(const char* command, const AskedForm& asked,
                               const WrittenForms& written);

// What else writes files with this ending, as the end of a sentence: "; 'beespace export' writes
// .kml"; or nothing.
std::string written_elsewhere(const char* command, const std::string& ending);

}  // namespace beespace::cli
