#include "cli/output/output_form.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace beespace::cli {
namespace {

const char* word_for(Form form) {
  switch (form) {
    case Form::kText:
      return "txt";
    case Form::kCsv:
      return "csv";
    case Form::kJson:
      return "json";
    case Form::kGeoJson:
      return "geojson";
  }
  return "";
}

bool writes(const WrittenForms& written, Form form) {
  return std::find(written.forms.begin(), written.forms.end(), form) != written.forms.end();
}

std::optional<Form> form_named(const std::string& ending, const WrittenForms& written) {
  const auto& text = written.text_endings;
  const bool plain = std::find(text.begin(), text.end(), ending) != text.end();
  if (plain && writes(written, Form::kText)) return Form::kText;
  for (const Form form : written.forms) {
    if (form != Form::kText && ending == word_for(form)) return form;
  }
  return std::nullopt;
}

// ".txt, .tsv, .csv or .json".
std::string endings_of(const WrittenForms& written) {
  std::vector<std::string> endings = {"txt"};
  if (writes(written, Form::kText)) {
    endings.insert(endings.end(), written.text_endings.begin(), written.text_endings.end());
  }
  for (const Form form : written.forms) {
    if (form != Form::kText) endings.emplace_back(word_for(form));
  }
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i) {
    if (i > 0) text += i + 1 < endings.size() ? ", " : " or ";
    (text += '.') += endings[i];
  }
  return text;
}

}  // namespace

FileEnding file_ending(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  std::string file(slash == std::string_view::npos ? name : name.substr(slash + 1));
  for (char& c : file) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  FileEnding of;
  of.compressed = file.ends_with(".gz");
  if (of.compressed) file.resize(file.size() - 3);
  const std::size_t dot = file.rfind('.');
  if (dot != std::string::npos) of.ending = file.substr(dot + 1);
  return of;
}

std::string written_elsewhere(const char* command, const std::string& ending) {
  const struct {
    const char* ending;
    const char* command;
  } table[] = {{"kml", "export"}, {"czml", "export"}, {"geojson", "export"}, {"svg", "plot"},
               {"png", "plot"},   {"html", "report"}, {"npy", "generate"}};
  for (const auto& other : table) {
    if (ending != other.ending || std::string_view(command) == other.command) continue;
    return std::string("; 'beespace ") + other.command + "' writes ." + ending;
  }
  return {};
}

Result<OutputForm> output_form(const char* command, const AskedForm& asked,
                               const WrittenForms& written) {
  if (int{asked.csv} + int{asked.json} + int{asked.geojson} > 1) {
    const bool maps = writes(written, Form::kGeoJson);
    return usage_error(command, maps ? "--csv, --json and --geojson exclude each other"
                                     : "--csv and --json exclude each other");
  }
  std::optional<Form> option;
  if (asked.csv) option = Form::kCsv;
  if (asked.json) option = Form::kJson;
  if (asked.geojson) option = Form::kGeoJson;
  const Form otherwise =
      option.value_or(writes(written, Form::kText) ? Form::kText : written.forms.front());
  if (asked.output == "-") return OutputForm{otherwise};
  const FileEnding of = file_ending(asked.output);
  const io::Packing packing = of.compressed ? io::Packing::kGzip : io::Packing::kPlain;
  // Any text may be called .txt.
  if (of.ending.empty() || of.ending == "txt") return OutputForm{otherwise, packing};
  const auto named = form_named(of.ending, written);
  const std::string output = std::string("'").append(printable(asked.output)).append("'");
  if (!named) {
    return usage_error(
        command, "'beespace " + std::string(command) + "' writes no ." + printable(of.ending) +
                     ", as the name of " + output + " says; let it end in " + endings_of(written) +
                     ", perhaps with .gz behind it" + written_elsewhere(command, of.ending));
  }
  if (option && *option != *named) {
    return usage_error(
        command, std::string("--") + word_for(*option) + " contradicts the ending of " + output +
                     "; leave the option out, or let the name end in ." + word_for(*option));
  }
  return OutputForm{*named, packing};
}

}  // namespace beespace::cli
