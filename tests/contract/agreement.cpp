#include "tests/contract/agreement.hpp"

#include <algorithm>

namespace beespace::test {

const std::vector<std::uint64_t>& expected_digests() {
  static const std::vector<std::uint64_t> digests = [] {
    std::vector<std::uint64_t> all;
    const Variant reference = brute_force_reference();
    for (const Inquiry& inquiry : inquiries()) all.push_back(digest(reference.ask(inquiry)));
    return all;
  }();
  return digests;
}

std::string first_difference(const Answer& found, const Answer& expected) {
  const auto [a, b] = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
  std::string text = std::to_string(found.size()) + " words, expected " +
                     std::to_string(expected.size()) + "; word " +
                     std::to_string(a - found.begin()) + " is ";
  text += a == found.end() ? "missing" : std::to_string(*a);
  text += ", expected ";
  return text + (b == expected.end() ? "no more" : std::to_string(*b));
}

void expect_brute_force_of(const Variant& variant) {
  constexpr int kShown = 8;
  int different = 0;
  const std::vector<std::uint64_t>& expected = expected_digests();
  const Variant reference = brute_force_reference();
  for (std::size_t i = 0; i < inquiries().size(); ++i) {
    const Inquiry& inquiry = inquiries()[i];
    if (!asks(variant, inquiry.question)) continue;
    const Answer found = variant.ask(inquiry);
    if (digest(found) == expected[i] || ++different > kShown) continue;
    ADD_FAILURE() << variant.name << " differs from " << reference.name << "\n"
                  << described(inquiry) << "\n"
                  << first_difference(found, reference.ask(inquiry));
  }
  EXPECT_EQ(different, 0) << variant.name << " differs in so many of " << inquiries().size()
                          << " inquiries; the first " << kShown << " are shown";
}

}  // namespace beespace::test
