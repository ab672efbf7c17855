// The JSON documents that a show is made of, and what in them refers to each other.
//
// In place of any value may stand {"$ref": "./drones/1/trajectory.json#/points"}: a file of the
// same archive, relative to the one that refers, and a JSON pointer into it.
#pragma once

#include "io/bytes/zip_archive.hpp"
#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace beespace::io {

struct ShowValue {
  JsonElement element;
  std::string member = {};  // the file of the archive; empty when the show is one JSON file
};

class ShowDocuments {
 public:
  static constexpr std::string_view kRoot = "show.json";

  // Errors: those of ZipArchive::read() and JsonDocument::parse().
  static Result<ShowDocuments> from_archive(ZipArchive archive);
  static Result<ShowDocuments> from_text(std::string_view text, std::string source);

  [[nodiscard]] ShowValue root() const;
  // What to blame: "show.skyc!drones/1/trajectory.json".
  [[nodiscard]] std::string place_of(const ShowValue& value) const;

  // What `value` refers to, or `value`. Errors: kUnsupportedFormat for references that lead out of
  // the show, kMissingColumn for those that lead nowhere, kCorrupt for those that go in a circle.
  Result<ShowValue> resolve(ShowValue value);

  // Member `key` of an object, resolved; nothing where there is none, or it is null.
  Result<std::optional<ShowValue>> member(const ShowValue& object, std::string_view key);

  // The files of the archive that nothing led to so far.
  [[nodiscard]] std::vector<std::string> unread() const;

  // Lets go of documents other than the root where they have become many: values in them are
  // invalid then.
  void forget_parts();

 private:
  ShowDocuments(JsonDocument root, std::string source)
      : root_(std::move(root)), source_(std::move(source)) {}
  // The document in `member`, parsed once.
  Result<ShowValue> document(const std::string& member);
  Result<ShowValue> follow(const ShowValue& from, std::string_view reference);

  JsonDocument root_;
  std::string source_;
  std::optional<ZipArchive> archive_;
  std::unordered_map<std::string, JsonDocument> parts_;
  std::size_t parts_bytes_ = 0;
  std::unordered_set<std::string> read_;  // of the archive
};

}  // namespace beespace::io
