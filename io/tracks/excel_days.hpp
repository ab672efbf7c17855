// Times as Excel keeps them: days since 1900 and their fractions, which a table may have instead of
// the dates that Excel shows. Nothing tells them from seconds, so they are asked about.
#pragma once

#include "io/tracks/first_fields.hpp"

#include <string_view>

namespace beespace::io {

// Whether they may be such days, of the years 1954 to 2119.
bool may_be_excel_days(const FirstFields& times);

// Behind a question what they are.
inline constexpr std::string_view kExcelDaysAdvice =
    "; if these are days as Excel counts them (44927.5 is noon on 2023-01-01), let Excel show the "
    "column as yyyy-mm-dd hh:mm:ss, and save the table again";

}  // namespace beespace::io
