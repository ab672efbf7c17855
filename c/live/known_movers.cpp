#include "c/live/known_movers.hpp"

#include "c/door/agents.hpp"
#include "c/door/points.hpp"

namespace beespace::c {

void write_movers(std::span<const LiveMover> movers, std::span<const Silence> silences,
                  beespace_movers& into) {
  into.resize(movers.size());
  auto silence = silences.begin();
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const LiveMover& mover = movers[i];
    into.ids[i] = agent_number_of(mover.id);
    write_three(mover.mover.position, &into.positions[3 * i]);
    write_three(mover.mover.velocity, &into.velocities[3 * i]);
    into.heard_s[i] = mover.heard_s;
    write_three(mover.heard_at, &into.heard_at[3 * i]);
    into.stale[i] = mover.stale ? 1 : 0;
    into.move[i] = mover.moves ? 1 : 0;
    into.unknown_s[i] = 0.0;
    if (silence == silences.end() || silence->id != mover.id) continue;
    into.unknown_s[i] = silence->unknown_s;
    ++silence;
  }
}

}  // namespace beespace::c

void beespace_movers::resize(std::size_t size) {
  ids.resize(size);
  positions.resize(3 * size);
  velocities.resize(3 * size);
  heard_s.resize(size);
  heard_at.resize(3 * size);
  stale.resize(size);
  move.resize(size);
  unknown_s.resize(size);
}

extern "C" {

beespace_movers* beespace_movers_create(void) {
  try {
    return new beespace_movers;
  } catch (...) {
    return nullptr;
  }
}

void beespace_movers_free(beespace_movers* movers) {
  delete movers;
}

int64_t beespace_movers_size(const beespace_movers* movers) {
  return movers == nullptr ? 0 : static_cast<int64_t>(movers->ids.size());
}

const int64_t* beespace_movers_ids(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->ids.data();
}

const double* beespace_movers_positions(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->positions.data();
}

const double* beespace_movers_velocities(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->velocities.data();
}

const double* beespace_movers_heard_s(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->heard_s.data();
}

const double* beespace_movers_heard_at(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->heard_at.data();
}

const uint8_t* beespace_movers_stale(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->stale.data();
}

const uint8_t* beespace_movers_move(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->move.data();
}

const double* beespace_movers_unknown_s(const beespace_movers* movers) {
  return movers == nullptr ? nullptr : movers->unknown_s.data();
}

}  // extern "C"
