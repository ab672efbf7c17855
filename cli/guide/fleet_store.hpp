// What a planner must remember on the disk: its epoch, and who is in the fleet. A planner that is
// started anew has a greater epoch than all before it, and knows whom it must find.
#pragma once

#include "io/bytes/file_lock.hpp"

#include <beespace/guide.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace beespace::cli {

class FleetStore {
 public:
  using Members = std::map<std::string, JoinRequest, std::less<>>;

  // Reads what the planner before has stored, and stores that this one has the next epoch, or
  // `least` where that is greater. The file is its own until it goes. An empty `path`: nothing is
  // remembered. Errors: another planner works with the file; it is something else; of the disk.
  static Result<FleetStore> open(const std::string& path, std::uint32_t least);

  [[nodiscard]] std::uint32_t epoch() const { return epoch_; }
  [[nodiscard]] const Members& members() const { return members_; }
  void put(const std::string& name, const JoinRequest& request);
  void remove(const std::string& name);
  // To the disk, where something has changed. Never over what a planner of a later epoch stored:
  // kWriteFailed.
  Status write();

 private:
  explicit FleetStore(std::string path) : path_(std::move(path)) {}
  Status read();
  [[nodiscard]] Status check_latest() const;

  io::FileLock lock_;
  std::string path_;
  std::uint32_t epoch_ = 0;
  Members members_;
  bool changed_ = true;
};

}  // namespace beespace::cli
