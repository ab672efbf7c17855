#include "io/shows/show_documents.hpp"

#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kMostKept = std::size_t{64} << 20;  // bytes of text

// `path` as seen from the file `from`, without "." and ".."; nothing when it leads out.
std::optional<std::string> path_within(std::string_view from, std::string_view path) {
  if (path.empty() || path.front() == '/' || path.find(':') != std::string_view::npos ||
      path.find('\\') != std::string_view::npos || path.find('\0') != std::string_view::npos) {
    return std::nullopt;
  }
  std::vector<std::string_view> parts;
  const auto walk = [&parts](std::string_view rest) {
    while (!rest.empty()) {
      const std::size_t slash = rest.find('/');
      const std::string_view part = rest.substr(0, slash);
      rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
      if (part.empty() || part == ".") continue;
      if (part == ".." && parts.empty()) return false;
      if (part == "..") {
        parts.pop_back();
      } else {
        parts.push_back(part);
      }
    }
    return true;
  };
  const std::size_t folder = from.rfind('/');
  if (folder != std::string_view::npos && !walk(from.substr(0, folder))) return std::nullopt;
  if (!walk(path) || parts.empty()) return std::nullopt;
  std::string joined;
  for (const std::string_view part : parts) {
    joined.append(joined.empty() ? "" : "/").append(part);
  }
  return joined;
}

constexpr std::string_view kReference = "$ref";

std::optional<std::string_view> reference_in(JsonElement element) {
  const auto member = json_member(element, kReference);
  std::string_view reference;
  if (!member || !member->get(reference)) return std::nullopt;
  return reference;
}

}  // namespace

Result<ShowDocuments> ShowDocuments::from_archive(ZipArchive archive) {
  const std::string name(kRoot);
  const auto bytes = archive.read(name);
  if (!bytes) return bytes.error();
  std::string place = archive.place_of(name);
  auto root = JsonDocument::parse(without_byte_order_mark(bytes->view), place);
  if (!root) return root.error();
  ShowDocuments documents(std::move(root).value(), std::move(place));
  documents.archive_ = std::move(archive);
  return documents;
}

Result<ShowDocuments> ShowDocuments::from_text(std::string_view text, std::string source) {
  auto root = JsonDocument::parse(text, source);
  if (!root) return root.error();
  return ShowDocuments(std::move(root).value(), std::move(source));
}

ShowValue ShowDocuments::root() const {
  return {root_.root(), archive_ ? std::string(kRoot) : std::string()};
}

std::string ShowDocuments::place_of(const ShowValue& value) const {
  return archive_ ? archive_->place_of(value.member) : source_;
}

Result<ShowValue> ShowDocuments::document(const std::string& member) {
  if (!archive_ || member == kRoot) return root();
  const auto known = parts_.find(member);
  if (known != parts_.end()) return ShowValue{known->second.root(), member};
  const auto bytes = archive_->read(member);
  if (!bytes) return bytes.error();
  read_.insert(member);
  auto parsed =
      JsonDocument::parse(without_byte_order_mark(bytes->view), archive_->place_of(member));
  if (!parsed) return parsed.error();
  parts_bytes_ += bytes->view.size();
  const auto place = parts_.emplace(member, std::move(parsed).value()).first;
  return ShowValue{place->second.root(), member};
}

Result<ShowValue> ShowDocuments::follow(const ShowValue& from, std::string_view reference) {
  const auto problem = [&](ErrorCode code, const std::string& why) {
    return Error{code, "the reference " + excerpt(reference) + " " + why, {place_of(from)}};
  };
  const std::size_t hash = std::min(reference.find('#'), reference.size());
  const std::string_view file = reference.substr(0, hash);
  const std::string_view pointer = reference.substr(std::min(hash + 1, reference.size()));
  std::string member = from.member;
  if (!file.empty()) {
    if (!archive_) {
      return problem(ErrorCode::kUnsupportedFormat,
                     "leads to another file; name the .skyc archive that holds both");
    }
    const auto path = path_within(from.member, file);
    if (!path) {
      return problem(ErrorCode::kUnsupportedFormat,
                     "leads out of the archive; put what it means inside");
    }
    member = *path;
    if (!archive_->contains(member)) {
      return problem(ErrorCode::kMissingColumn,
                     "leads to a file that is not in the archive; export the show again");
    }
  }
  auto target = document(member);
  if (!target || pointer.empty()) return target;
  if (!target->element.follow(pointer, target->element)) {
    return problem(ErrorCode::kMissingColumn, "leads nowhere; export the show again");
  }
  return target;
}

Result<ShowValue> ShowDocuments::resolve(ShowValue value) {
  std::vector<std::string> passed;
  while (const auto reference = reference_in(value.element)) {
    std::string here = value.member + "\n" + std::string(*reference);
    if (std::find(passed.begin(), passed.end(), here) != passed.end()) {
      return Error{
          ErrorCode::kCorrupt,
          "the reference " + excerpt(*reference) + " leads back to itself; export the show again",
          {place_of(value)}};
    }
    passed.push_back(std::move(here));
    auto target = follow(value, *reference);
    if (!target) return target;
    value = std::move(target).value();
  }
  return value;
}

Result<std::optional<ShowValue>> ShowDocuments::member(const ShowValue& object,
                                                       std::string_view key) {
  if (auto error = json_twice(object.element, {key, kReference})) {
    error->location.source = place_of(object);
    return *std::move(error);
  }
  const auto found = json_member(object.element, key);
  if (!found) return std::optional<ShowValue>();
  auto resolved = resolve({*found, object.member});
  if (!resolved) return resolved.error();
  if (resolved->element.is_null()) return std::optional<ShowValue>();
  return std::optional<ShowValue>(std::move(resolved).value());
}

std::vector<std::string> ShowDocuments::unread() const {
  std::vector<std::string> unread;
  if (!archive_) return unread;
  for (const std::string& name : archive_->names()) {
    if (name != kRoot && !read_.contains(name)) unread.push_back(name);
  }
  return unread;
}

void ShowDocuments::forget_parts() {
  if (parts_bytes_ <= kMostKept) return;
  parts_.clear();
  parts_bytes_ = 0;
}

}  // namespace beespace::io
