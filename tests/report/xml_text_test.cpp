// Hostile text in XML.
#include "report/xml_text.hpp"

#include <gtest/gtest.h>

namespace beespace::report {
namespace {

constexpr const char* kBroken = "\xEF\xBF\xBD";

TEST(XmlText, EscapesWhatMarkupIsMadeOf) {
  EXPECT_EQ(xml_text("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(xml_text("]]>"), "]]&gt;");
  EXPECT_EQ(xml_text("a\tb\nc\r"), "a&#9;b&#10;c&#13;");
  EXPECT_EQ(xml_text("M\u00e4ya \U0001F41D"), "M\u00e4ya \U0001F41D");
}

TEST(XmlText, ReplacesWhatXmlForbids) {
  using namespace std::string_literals;
  EXPECT_EQ(xml_text("a\0b\x01\x1F\x7F"s), "a"s + kBroken + "b" + kBroken + kBroken + kBroken);
  EXPECT_EQ(xml_text("\xFFz"), kBroken + "z"s);
  EXPECT_EQ(xml_text("\xC3"), kBroken);            // cut short
  EXPECT_EQ(xml_text("\xED\xA0\x80").size(), 9u);  // a surrogate: three broken bytes
  EXPECT_EQ(xml_text("\xEF\xBF\xBE\xEF\xBF\xBF"),
            std::string(kBroken) + kBroken);  // U+FFFE, U+FFFF
}

TEST(XmlText, OnOneLineThereAreNoLineEnds) {
  EXPECT_EQ(one_line("a\nb\tc\xFF<"), std::string("a b c") + kBroken + "<");
}

}  // namespace
}  // namespace beespace::report
