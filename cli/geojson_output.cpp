#include "cli/answer_output.hpp"
#include "cli/block_writer.hpp"
#include "cli/number_text.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

// RFC 7946 has longitudes from -180 to 180. The remainder is exact; + 0.0 turns -0 into 0.
double within_half_turn(double longitude_deg) {
  if (std::abs(longitude_deg) <= 180.0) return longitude_deg;
  return std::remainder(longitude_deg, 360.0) + 0.0;
}

}  // namespace

void write_geojson(const io::LoadedPoints& loaded, const Detection& detection, const ShownIds& ids,
                   bool nearest, io::AtomicOutput& output) {
  BlockWriter out(output);
  out.text += "{\"type\": \"FeatureCollection\", \"features\": [";
  bool first = true;
  io::for_each_record(loaded, detection.at_risk, [&](const io::Record& record) {
    out.text += first ? "\n" : ",\n";
    first = false;
    out.text += R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [)";
    append_exact(out.text, within_half_turn(record.geographic.longitude_deg));
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
