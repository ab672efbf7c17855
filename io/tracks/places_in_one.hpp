// Tables whose places are not in columns of their own: what to type.
#pragma once

#include "io/table/table_layout.hpp"
#include "io/tracks/listed_places.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether these keys name a position, as the header of a table does.
bool keys_name_position(const std::vector<std::string_view>& keys);

// Where JSON comes from: a file becomes another one, lines that come one by one go through.
enum class JsonFrom : std::uint8_t { kFile, kLines };

// JSON with "position": [x, y, z], or {"x": x, ...}.
std::optional<Error> place_in_one_value(std::string_view text, const TableLayout& table,
                                        JsonFrom from);

// Whether what the first record has of that name is an object within it.
bool holds_objects(std::string_view text, const TableLayout& table, std::string_view name);

// JSON of which no key names a position, and some hold objects: {"pose": {"x": 1, "y": 2}}.
Error places_within_objects(JsonFrom from);

// JSON whose objects hold lists of places, as that says.
Error places_in_list(const ListedPlaces& listed, JsonFrom from);

// Columns under two lines of names, as pandas writes them: "agent,A,A,A", "coord,x,y,z".
std::optional<Error> columns_of_pandas(std::string_view text, const TableLayout& table);

}  // namespace beespace::io
