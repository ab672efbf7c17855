// No answer replaces what it comes from, whatever name that goes by.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kFlown =
    "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,30,0,0\nb,9,30,0,0\n";
constexpr std::string_view kBees = "id,x,y,z\na,0,0,0\nb,3,0,0\n";

class OutputFile : public testing::Test {
 protected:
  // The error is reported, and no file has been touched.
  void expect_refused(const Arguments& arguments, const std::string& message,
                      std::string_view input = {}) {
    const std::vector<std::string> before = folder_.names();
    expect_failure(arguments, input, 2, message);
    EXPECT_EQ(folder_.read("in.csv"), kFlown);
    EXPECT_EQ(folder_.names(), before);
  }

  TemporaryFolder folder_;
  std::string in_ = folder_.file("in.csv", kFlown);
  std::string other_ = folder_.file("other.csv", kFlown);
};

TEST_F(OutputFile, IsNotTheInputOfAnyCommand) {
  const std::string message = "--output " + in_ + " is the input itself; name another file";
  for (const char* command : {"detect", "predict", "replay", "verify", "advise"}) {
    expect_refused({command, in_, "--output", in_}, message);
  }
  expect_refused({"export", in_, "-o", in_}, message);
  expect_refused({"simulate", in_, "--output", in_}, message);
}

TEST_F(OutputFile, IsNoneOfSeveralInputs) {
  const std::string message = "--output " + in_ + " is one of the inputs; name another file";
  expect_refused({"detect", other_, "--others", in_, "--output", in_}, message);
  expect_refused({"replay", other_, in_, "--output", in_}, message);
  expect_refused({"export", other_, in_, "--output", in_}, message);
  expect_refused({"verify", other_, "--obstacles", in_, "--output", in_}, message);
  expect_refused({"advise", other_, "--obstacles", in_, "--output", in_}, message);
  expect_refused({"advise", other_, "--intruders", in_, "--output", in_}, message);
  expect_refused({"simulate", other_, "--obstacles", in_, "--output", in_}, message);
}

TEST_F(OutputFile, IsNotTheInputByALink) {
  std::filesystem::create_symlink("in.csv", folder_.path("page.html"));
  std::filesystem::create_hard_link(in_, folder_.path("picture.svg"));
  for (const auto& [command, link] :
       {std::pair{"report", "page.html"}, std::pair{"plot", "picture.svg"}}) {
    const std::string output = folder_.path(link);
    expect_refused({command, in_, "-o", output}, output + " is the input itself");
    expect_refused({command, other_, in_, "-o", output}, output + " is one of the inputs");
  }
  expect_refused({"report", other_, "--compare", in_, "-o", folder_.path("page.html")},
                 "is one of the inputs");
}

TEST_F(OutputFile, IsNoFileOfAFolderThatIsRead) {
  const std::string folder = folder_.path("");
  expect_refused({"replay", folder, "--output", in_}, "--output " + in_ + " is the input itself");
  EXPECT_EQ(run({"replay", folder, "--one-clock", "--output", folder_.path("new.csv")}).exit_code,
            0);
  EXPECT_EQ(folder_.read("in.csv"), kFlown);
}

TEST_F(OutputFile, MayReplaceAnyOtherFile) {
  const std::string bees = folder_.file("bees.csv", kBees);
  const std::string old = folder_.file("old.txt", kBees);  // the same in it, but another file
  EXPECT_EQ(run({"detect", bees, "--output", old}).exit_code, 0);
  EXPECT_EQ(folder_.read("old.txt"), "a\nb\n");
}

TEST_F(OutputFile, DevicesAndStandardOutputAreNotReplaced) {
  const std::string bees = folder_.file("bees.csv", kBees);
  EXPECT_EQ(run({"detect", bees, "--output", "/dev/null"}).exit_code, 0);
  EXPECT_EQ(run({"detect", "/dev/stdin", "--output", "/dev/stdout"}, kBees).out, "a\nb\n");
  EXPECT_EQ(run({"detect", "-", "--output", "-"}, kBees).out, "a\nb\n");
  EXPECT_EQ(run({"detect", "/dev/null", "--output", "/dev/null"}).exit_code, 3);  // it is empty
}

}  // namespace
}  // namespace beespace::cli_test
