#include "sweep/sweep_all.hpp"

#include <algorithm>

namespace beespace::cpu {

namespace {

// The results of one worker, for its query points and for the others that these reach, for which
// another worker may have results at the same time. Where a swarm is swept by itself, queries and
// others are the same points, and so are the results.
template <class Note>
struct Notes {
  Notes(const SweepQuery& asking, Range points, Range reach_of_points, core::Memory& memory)
      : question(asking),
        asked(points),
        reach(reach_of_points),
        both(asking.by_itself()),
        of_asked(both ? 0 : asked.end - asked.begin + core::kPadding, Note{}, &memory),
        of_reach(both ? reach.end - reach.begin + core::kPadding : 0, Note{}, &memory) {}

  [[nodiscard]] Note* asked_notes() { return both ? of_reach.data() : of_asked.data(); }
  [[nodiscard]] Note* other_notes() { return of_reach.data(); }
  [[nodiscard]] std::uint32_t first_asked() const { return asked.begin; }

  const SweepQuery& question;
  Range asked;
  Range reach;
  bool both;
  core::Vector<Note> of_asked;
  core::Vector<Note> of_reach;
};

template <class Note>
using Parts = core::Vector<std::optional<Notes<Note>>>;

// Calls sweep_part(notes) for every worker's part.
template <class Note, class SweepPart>
void sweep_parts(const SweepQuery& question, const core::Resources& with, Parts<Note>& parts,
                 SweepPart&& sweep_part) {
  with.crew.split(
      question.asked.grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
        if (begin == end) return;
        const Range points{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        const RowSweeps map(question, {nullptr, nullptr});
        parts[worker].emplace(question, points, map.reach(points.begin, points.end),
                              with.memory.of(worker));
        sweep_part(*parts[worker]);
      });
}

// Calls first(id, note) once for every point, then add(id, note) for each other result about it:
// parts reach into each other, so results beyond their own points are added afterwards, one part
// after another.
template <class Note, class First, class Add>
void read_notes(const SweepQuery& question, const core::Resources& with, Parts<Note>& parts,
                const First& first, const Add& add) {
  const PointId* const id = question.asked.grid.id;
  with.crew.split(question.asked.grid.size,
                  [&](std::size_t begin, std::size_t end, unsigned worker) {
                    if (begin == end) return;
                    const Note* const notes = parts[worker]->asked_notes();
                    for (std::size_t i = begin; i < end; ++i) first(id[i], notes[i - begin]);
                  });
  for (std::optional<Notes<Note>>& part : parts) {
    if (!part || !part->both) continue;
    const std::uint32_t first_noted = part->reach.begin;
    const Note* const notes = part->other_notes();
    with.crew.split(
        part->reach.end - part->asked.end, [&](std::size_t begin, std::size_t end, unsigned) {
          for (std::size_t i = part->asked.end + begin; i < part->asked.end + end; ++i) {
            add(id[i], notes[i - first_noted]);
          }
        });
  }
}

}  // namespace

void mark_all(const SweepQuery& question, const core::Resources& with, std::uint8_t* at_risk) {
  Parts<std::uint8_t> parts(with.crew.size(), &with.memory);
  sweep_parts(question, with, parts, [](Notes<std::uint8_t>& notes) {
    const auto decide = [](void* context, std::uint32_t i, std::uint32_t j) {
      auto& mine = *static_cast<Notes<std::uint8_t>*>(context);
      const bool known = mine.asked_notes()[i - mine.asked.begin] != 0 &&
                         (!mine.both || mine.other_notes()[j - mine.reach.begin] != 0);
      return !known && mine.question.decide(i, j);
    };
    const Marks marks{notes.asked_notes(), notes.other_notes(), notes.asked.begin,
                      notes.reach.begin};
    const Kernels& kernels = notes.question.kernels;
    const auto kernel = notes.both ? kernels.mark : kernels.mark_asked;
    RowSweeps(notes.question, {decide, &notes})
        .for_each(notes.asked.begin, notes.asked.end, [&](const Sweep& sweep) {
          kernel(sweep, marks);
          return true;
        });
  });
  read_notes(
      question, with, parts,
      [at_risk](PointId id, std::uint8_t mark) { at_risk[id] = mark != 0 ? 1 : 0; },
      [at_risk](PointId id, std::uint8_t mark) { at_risk[id] = mark != 0 ? 1 : at_risk[id]; });
}

void count_all(const SweepQuery& question, const core::Resources& with, std::uint32_t* counts) {
  Parts<std::uint32_t> parts(with.crew.size(), &with.memory);
  sweep_parts(question, with, parts, [](Notes<std::uint32_t>& notes) {
    const Counts into{notes.asked_notes(), notes.other_notes(), notes.asked.begin,
                      notes.reach.begin};
    const Kernels& kernels = notes.question.kernels;
    const auto kernel = notes.both ? kernels.count : kernels.count_asked;
    RowSweeps(notes.question, decided_by(notes.question))
        .for_each(notes.asked.begin, notes.asked.end, [&](const Sweep& sweep) {
          kernel(sweep, into);
          return true;
        });
  });
  read_notes(
      question, with, parts, [counts](PointId id, std::uint32_t count) { counts[id] = count; },
      [counts](PointId id, std::uint32_t count) { counts[id] += count; });
}

}  // namespace beespace::cpu
