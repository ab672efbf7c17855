// Every way in which beespace can answer, behind one door.
#pragma once

#include "tests/contract/answer.hpp"
#include "tests/contract/inquiry.hpp"

#include <beespace/crew.hpp>

#include <algorithm>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace beespace::test {

struct Variant {
  std::string name;
  // Called many times in turn: what a variant keeps from one call must not show in the next.
  std::function<Answer(const Inquiry&)> ask;
  std::vector<Question> questions = {};  // those that it is for; empty: all
};

inline bool asks(const Variant& variant, Question question) {
  const auto& only = variant.questions;
  return only.empty() || std::find(only.begin(), only.end(), question) != only.end();
}

// What GoogleTest shows of a variant.
inline void PrintTo(const Variant& variant, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << variant.name;
}

// From the definition, in integers of any size.
Variant oracle();

Variant brute_force_reference();

// The functions of the public headers. Small scenes never get more than one thread.
Variant public_functions(unsigned threads);
Variant public_functions_of_strided_points();

// One Engine that lives through all inquiries. All of a crew work on every scene.
Variant engine_with_threads(unsigned threads);
Variant engine_with_crew(const std::string& name, std::shared_ptr<Crew> crew);

std::vector<Variant> forced_kernels();
std::vector<Variant> forced_crowds();
std::vector<Variant> forced_methods();
std::vector<Variant> forced_trees();
// As if the others lay on a shell: slow where many do not.
std::vector<Variant> forced_shells();

// All variants that are compared with brute force on every inquiry. Here several workers run on one
// thread: real threads would spend their time waking each other up; they are tested on large
// swarms, and concurrent callers on a sample of the inquiries.
std::vector<Variant> contract_variants();
// The variants whose threads share the work of a large swarm.
std::vector<Variant> variants_with_threads();

}  // namespace beespace::test
