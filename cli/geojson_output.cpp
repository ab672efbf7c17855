#include "cli/answer_output.hpp"
#include "cli/block_writer.hpp"
#include "cli/number_text.hpp"

namespace beespace::cli {

void write_geojson(const io::LoadedPoints& loaded, const Detection& detection, bool nearest,
                   io::AtomicOutput& output) {
  const ShownIds ids(loaded, detection.at_risk);
  BlockWriter out(output);
  out.text += "{\"type\": \"FeatureCollection\", \"features\": [";
  bool first = true;
  io::for_each_record(loaded, detection.at_risk, [&](const io::Record& record) {
    out.text += first ? "\n" : ",\n";
    first = false;
    out.text += R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [)";
    append_exact(out.text, record.geographic.longitude_deg);
    out.text += ", ";
    append_exact(out.text, record.geographic.latitude_deg);
    out.text += ", ";
    append_exact(out.text, record.geographic.height_m);
    out.text += R"(]}, "properties": {"id": )";
    ids.append_json(out.text, record.point);
    if (nearest) {
      out.text += ", \"nearest_m\": ";
      append_exact(out.text, detection.nearest[record.point].distance_m);
    }
    out.text += "}}";
    out.pass_on();
  });
  out.text += "\n]}\n";
}

}  // namespace beespace::cli
