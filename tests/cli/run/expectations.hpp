// Expectations about a run that several subcommands share, and its parsed answer.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"

namespace beespace::cli_test {

Arguments operator+(Arguments some, const Arguments& more);

std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> fields_of(const std::string& line, char delimiter);

// All lines taken apart; of tables between tabs, which begin with a header line, those below it.
using TextRows = std::vector<std::vector<std::string>>;
TextRows rows_of(const std::string& text, char delimiter = '\t');

// Numbers may differ from those expected by 1e-5, other fields not at all.
void expect_rows(const TextRows& rows, const TextRows& expected);

// Rows of conflicts without their last column, how long each lasts, which must be what the ends are
// after the begins where these are numbers.
TextRows without_lasts(TextRows rows);

// Each of the parts is in the text.
void expect_parts(const std::string& text, std::initializer_list<std::string_view> parts);

// It ends with this status, writes this error, and no answer.
void expect_failure(const Arguments& arguments, std::string_view input, int exit_code,
                    const std::string& message, const Surroundings& surroundings = {});

// The same of a wrong command line.
void expect_usage_error(const Arguments& arguments, const std::string& message);

}  // namespace beespace::cli_test
