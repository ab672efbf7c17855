#include "cli/answer_output.hpp"
#include "cli/block_writer.hpp"
#include "cli/number_text.hpp"

namespace beespace::cli {
namespace {

// Arrays have no header of their own.
std::string_view header_of(const io::LoadedPoints& loaded) {
  if (loaded.format_description.starts_with("text")) return io::header_line(loaded);
  return loaded.frame == io::Frame::kWgs84 ? "longitude,latitude,height" : "x,y,z";
}

}  // namespace

void write_csv(const io::LoadedPoints& loaded, const Detection& detection, bool nearest,
               io::AtomicOutput& output) {
  const char delimiter = io::delimiter(loaded);
  BlockWriter out(output);
  const std::string_view header = header_of(loaded);
  if (!header.empty()) {
    out.text += header;
    if (nearest) (out.text += delimiter) += "nearest_m";
    out.text += '\n';
  }
  io::for_each_record(loaded, detection.at_risk, [&](const io::Record& record) {
    out.text += record.text;
    if (nearest) {
      out.text += delimiter;
      append_exact(out.text, detection.nearest[record.point].distance_m);
    }
    out.text += '\n';
    out.pass_on();
  });
}

}  // namespace beespace::cli
