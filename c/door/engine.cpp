#include "c/door/engine.hpp"

extern "C" {

beespace_engine* beespace_engine_create(void) {
  try {
    return new beespace_engine;
  } catch (...) {
    return nullptr;
  }
}

void beespace_engine_free(beespace_engine* engine) {
  delete engine;
}

void beespace_engine_release_memory(beespace_engine* engine) {
  if (engine == nullptr) return;
  engine->engine.release_memory();
  engine->ids = {};
  engine->pairs = {};
  engine->conflicts = {};
  engine->counts = {};
  engine->nearest = {};
  engine->rows = {};
  engine->nearest_rows = {};
}

}  // extern "C"
