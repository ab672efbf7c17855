// HDF5, archives of NumPy, spreadsheets and XML hold anything: which program wrote them, as names
// within tell, and what makes a table of it.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// All of the file, or as much of it as there is, beginning as one of HDF5.
std::string words_of_hdf5(std::string_view bytes);

// The same of a zip archive; nothing where it is none of NumPy (.npz).
std::string words_of_npz(std::string_view bytes);

// The same of a zip archive; nothing where it is no spreadsheet (.xlsx, .ods).
std::string words_of_workbook(std::string_view bytes);

// The same of XML; nothing where nothing better is known.
std::string words_of_xml(std::string_view bytes);

}  // namespace beespace::io
