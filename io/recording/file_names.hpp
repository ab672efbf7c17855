// Names of bees that are of one file, as frames of ROS are: in another file the same name may be
// another bee.
#pragma once

#include "io/recording/recording.hpp"

#include <string>
#include <string_view>
#include <unordered_map>

namespace beespace::io {

class FileNames {
 public:
  // What to call the bee `id` of that file until all are known: "file:id". As long as this lives.
  std::string_view name_of(std::string_view file, std::string_view id);

  // Once all are known: each is called by its id alone where no two are called so.
  void shorten(Recording& recording) const;

 private:
  std::unordered_map<std::string, std::string> ids_;  // by the name
  std::string key_;
};

}  // namespace beespace::io
