// Writes messages of a fleet as fleet_reader.hpp reads them: doubles so that they are the same ones
// there. Each appends a line with its end.
#pragma once

#include "io/fleet/fleet_message.hpp"
#include "io/json/json_writer.hpp"

#include <string>
#include <string_view>

namespace beespace::io {

void append_message(std::string& out, std::string_view id, const FleetContent& content);

// [x, y, z]
void write_vector(JsonWriter& json, std::string_view key, const Point& point);
void write_vector(JsonWriter& json, std::string_view key, const Velocity& velocity);
void write_tick(JsonWriter& json, std::string_view key, Tick tick);

// An object: what a follower stores.
void write_stored(JsonWriter& json, const StoredBranch& stored);

}  // namespace beespace::io
