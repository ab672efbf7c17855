#include "cpu/sweep_all.hpp"

#include <algorithm>

namespace beespace::cpu {

namespace {

// What one worker notes down, about the points it asks for and about the others that these reach,
// which another worker may be noting something about at the same time. Swept by itself, a swarm's
// asked points and others are the same, and so are the notes.
template <class Note>
struct Notes {
  Notes(const Question& asking, Range points, Range reach_of_points, core::Memory& memory)
      : question(asking),
        asked(points),
        reach(reach_of_points),
        both(asking.by_itself()),
        of_asked(both ? 0 : asked.end - asked.begin + core::kPadding, Note{}, &memory),
        of_reach(both ? reach.end - reach.begin + core::kPadding : 0, Note{}, &memory) {}

  [[nodiscard]] Note* asked_notes() { return both ? of_reach.data() : of_asked.data(); }
  [[nodiscard]] Note* other_notes() { return of_reach.data(); }
  [[nodiscard]] std::uint32_t first_asked() const { return asked.begin; }

  const Question& question;
  Range asked;
  Range reach;
  bool both;
  core::Vector<Note> of_asked;
  core::Vector<Note> of_reach;
};

template <class Note>
using Parts = core::Vector<std::optional<Notes<Note>>>;

// Calls sweep_part(sweeps, notes) for every worker's part; combine(mine, note) then brings the
// notes of all workers together.
template <class Note, class SweepPart>
void sweep_parts(const Question& question, const core::Resources& with, Parts<Note>& parts,
                 SweepPart&& sweep_part) {
  with.crew.split(
      question.asked.grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
        if (begin == end) return;
        const Range points{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        const RowSweeps map(question, {nullptr, nullptr}, question.by_itself());
        parts[worker].emplace(question, points, map.reach(points.begin, points.end),
                              with.memory.of(worker));
        sweep_part(*parts[worker]);
      });
}

// Calls take(id, note) for everything noted. Parts overlap where they reach into each other, so
// they come one after another, each shared by the crew.
template <class Note, class Take>
void read_notes(const Question& question, const core::Resources& with, Parts<Note>& parts,
                Take&& take) {
  const PointId* const id = question.asked.grid.id;
  for (std::optional<Notes<Note>>& part : parts) {
    if (!part) continue;
    const Range noted = part->both ? part->reach : part->asked;
    const Note* const notes = part->asked_notes();
    with.crew.split(noted.end - noted.begin, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) take(id[noted.begin + i], notes[i]);
    });
  }
}

}  // namespace

void mark_all(const Question& question, const core::Resources& with, std::uint8_t* at_risk) {
  Parts<std::uint8_t> parts(with.crew.size(), &with.memory);
  sweep_parts(question, with, parts, [](Notes<std::uint8_t>& notes) {
    const auto decide = [](void* context, std::uint32_t i, std::uint32_t j) {
      auto& mine = *static_cast<Notes<std::uint8_t>*>(context);
      std::uint8_t& asked = mine.asked_notes()[i - mine.asked.begin];
      if (!mine.both) {
        if (asked == 0 && mine.question.decide(i, j)) asked = 1;
        return;
      }
      std::uint8_t& other = mine.other_notes()[j - mine.reach.begin];
      if ((asked == 0 || other == 0) && mine.question.decide(i, j)) asked = other = 1;
    };
    const Marks marks{notes.asked_notes(), notes.other_notes(), notes.asked.begin,
                      notes.reach.begin};
    const Kernels& kernels = notes.question.kernels;
    const auto kernel = notes.both ? kernels.mark : kernels.mark_asked;
    RowSweeps(notes.question, {decide, &notes}, notes.both)
        .for_each(notes.asked.begin, notes.asked.end, [&](const Sweep& sweep) {
          kernel(sweep, marks);
          return true;
        });
  });
  read_notes(question, with, parts, [at_risk](PointId id, std::uint8_t mark) {
    at_risk[id] = mark != 0 ? 1 : at_risk[id];
  });
}

void count_all(const Question& question, const core::Resources& with, std::uint32_t* counts) {
  Parts<std::uint32_t> parts(with.crew.size(), &with.memory);
  sweep_parts(question, with, parts, [](Notes<std::uint32_t>& notes) {
    const auto decide = [](void* context, std::uint32_t i, std::uint32_t j) {
      auto& mine = *static_cast<Notes<std::uint32_t>*>(context);
      if (!mine.question.decide(i, j)) return;
      ++mine.asked_notes()[i - mine.asked.begin];
      if (mine.both) ++mine.other_notes()[j - mine.reach.begin];
    };
    const Counts into{notes.asked_notes(), notes.other_notes(), notes.asked.begin,
                      notes.reach.begin};
    const Kernels& kernels = notes.question.kernels;
    const auto kernel = notes.both ? kernels.count : kernels.count_asked;
    RowSweeps(notes.question, {decide, &notes}, notes.both)
        .for_each(notes.asked.begin, notes.asked.end, [&](const Sweep& sweep) {
          kernel(sweep, into);
          return true;
        });
  });
  std::fill_n(counts, question.asked.points.size(), 0U);
  read_notes(question, with, parts,
             [counts](PointId id, std::uint32_t count) { counts[id] += count; });
}

}  // namespace beespace::cpu
