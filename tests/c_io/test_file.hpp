// A file that a test writes, gone with it; and handles of C that free themselves.
#pragma once

#include <beespace_io.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::test {

class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return path_ + "/" + name; }
  // Each writes a file and returns its path.
  [[nodiscard]] std::string file(const std::string& name, std::string_view content) const;
  [[nodiscard]] std::string gzip_file(const std::string& name, std::string_view content) const;

 private:
  std::string path_;
};

struct FreeRead {
  void operator()(beespace_io_points* points) const { beespace_io_points_free(points); }
  void operator()(beespace_io_recording* recording) const { beespace_io_recording_free(recording); }
  void operator()(beespace_io_page* page) const { beespace_io_page_free(page); }
};
using Page = std::unique_ptr<beespace_io_page, FreeRead>;
using Recording = std::unique_ptr<beespace_io_recording, FreeRead>;
using Points = std::unique_ptr<beespace_io_points, FreeRead>;

inline beespace_io_error io_error() {
  beespace_io_error error{};
  error.struct_size = sizeof error;
  return error;
}

inline beespace_io_options io_options() {
  beespace_io_options options{};
  options.struct_size = sizeof options;
  return options;
}

inline std::string text_of(const beespace_io_error& error) {
  char text[4096];
  beespace_io_error_text(&error, text, sizeof text);
  return text;
}

// What a call makes, through its pointer to a pointer.
struct ReadPoints {
  Points points;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
};
inline ReadPoints read_points(const std::string& path,
                              const beespace_io_options* options = nullptr) {
  ReadPoints read;
  beespace_io_points* points = nullptr;
  read.code = beespace_io_read_points(path.c_str(), options, &points, &read.error);
  read.points.reset(points);
  return read;
}

struct ReadRecording {
  Recording recording;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
};
inline ReadRecording read_recording(const std::vector<std::string>& paths,
                                    const beespace_io_options* options = nullptr) {
  std::vector<const char*> texts;
  for (const std::string& path : paths) texts.push_back(path.c_str());
  ReadRecording read;
  beespace_io_recording* recording = nullptr;
  read.code = beespace_io_read_recording(texts.data(), static_cast<std::int64_t>(texts.size()),
                                         options, &recording, &read.error);
  read.recording.reset(recording);
  return read;
}

template <class Number>
std::vector<Number> numbers_of(const Number* first, std::int64_t count) {
  return first == nullptr ? std::vector<Number>() : std::vector<Number>(first, first + count);
}

inline std::vector<double> xyz_of(const Points& points) {
  const double* const xyz = beespace_io_points_xyz(points.get());
  const auto count = static_cast<std::size_t>(beespace_io_points_count(points.get()));
  return xyz == nullptr ? std::vector<double>() : std::vector<double>(xyz, xyz + 3 * count);
}

inline std::vector<std::string> notes_of(const beespace_io_facts* facts) {
  std::vector<std::string> notes;
  for (std::int64_t i = 0; i < beespace_io_facts_note_count(facts); ++i) {
    notes.emplace_back(beespace_io_facts_note(facts, i));
  }
  return notes;
}

}  // namespace beespace::test
