#include "c_io/facts.hpp"

#include "analysis/text/unit_notes.hpp"
#include "c_io/door.hpp"
#include "c_io/wording.hpp"
#include "io/points/repeated_ids.hpp"

#include <cstddef>

namespace beespace::c_io {

namespace {

// A text of C ends with its first zero byte: what came behind one would be lost.
std::string as_c_text(std::string text) {
  for (char& c : text) {
    if (c == '\0') c = ' ';
  }
  return text;
}

// What both kinds of input have in common.
template <class Input>
beespace_io_facts common_facts(const Input& input) {
  beespace_io_facts facts;
  facts.frame = input.frame == io::Frame::kWgs84 ? "wgs84" : "metres";
  facts.frame_reason = as_c_text(in_words_of_programs(input.frame_reason));
  facts.format = as_c_text(input.format_description);
  facts.heights = analysis::datum_text(input.heights);
  for (const io::UnitTaken& taken : input.units) {
    facts.notes.push_back(as_c_text(in_words_of_programs(analysis::text_of(taken))));
  }
  for (const std::string& note : input.notes) {
    facts.notes.push_back(as_c_text(in_words_of_programs(note)));
  }
  facts.skipped = input.skipped;
  facts.skipped_count = static_cast<std::int64_t>(input.skipped_count);
  return facts;
}

}  // namespace

beespace_io_facts facts_of(const io::LoadedPoints& loaded) {
  beespace_io_facts facts = common_facts(loaded);
  const io::RepeatedIds repeated = io::find_repeated_ids(loaded);
  if (repeated.count > 0) facts.notes.push_back(as_c_text(analysis::text_of(repeated)));
  return facts;
}

beespace_io_facts facts_of(const io::Recording& recording) {
  return common_facts(recording);
}

}  // namespace beespace::c_io

extern "C" {

const char* beespace_io_facts_frame(const beespace_io_facts* facts) {
  return facts == nullptr ? "" : facts->frame.c_str();
}

const char* beespace_io_facts_frame_reason(const beespace_io_facts* facts) {
  return facts == nullptr ? "" : facts->frame_reason.c_str();
}

const char* beespace_io_facts_format(const beespace_io_facts* facts) {
  return facts == nullptr ? "" : facts->format.c_str();
}

const char* beespace_io_facts_heights(const beespace_io_facts* facts) {
  return facts == nullptr ? "" : facts->heights.c_str();
}

int64_t beespace_io_facts_note_count(const beespace_io_facts* facts) {
  return facts == nullptr ? 0 : static_cast<int64_t>(facts->notes.size());
}

const char* beespace_io_facts_note(const beespace_io_facts* facts, int64_t index) {
  if (index < 0 || index >= beespace_io_facts_note_count(facts)) return nullptr;
  return facts->notes[static_cast<std::size_t>(index)].c_str();
}

int64_t beespace_io_facts_skipped(const beespace_io_facts* facts) {
  return facts == nullptr ? 0 : facts->skipped_count;
}

beespace_code beespace_io_facts_skipped_error(const beespace_io_facts* facts, int64_t index,
                                              beespace_io_error* error) {
  if (facts == nullptr || index < 0) return BEESPACE_OK;
  const auto which = static_cast<std::size_t>(index);
  if (which >= facts->skipped.size()) return BEESPACE_OK;
  return beespace::c_io::enter(error, [&]() -> beespace::Status { return facts->skipped[which]; });
}

}  // extern "C"
