// Times a command as a whole process against a newline scan of the same mapped file.
//
// usage: end_to_end_benchmark FILE OUTPUT COMMAND [ARGUMENT ...]
// OUTPUT is what the command writes; it is removed before every run, since some file systems flush
// a file that is replaced. Prints one line: the medians over the runs of the scan's time, the
// command's wall time and CPU time, their ratios to the scan, and the command's peak memory beyond
// the file.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

namespace {

constexpr int kRuns = 7;

struct Run {
  double wall_ms = 0.0;
  double cpu_ms = 0.0;
  double peak_mb = 0.0;
};

[[noreturn]] void fail(const char* what) {
  std::perror(what);
  std::exit(1);
}

double now_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

std::string_view map_file(const char* path) {
  const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0 || fstat(descriptor, &status) != 0) fail(path);
  const auto size = static_cast<std::size_t>(status.st_size);
  void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
  if (data == MAP_FAILED) fail("mmap");
  close(descriptor);
  return {static_cast<const char*>(data), size};
}

double scan_ms(std::string_view text, std::size_t& lines) {
  const double start = now_ms();
  lines = 0;
  const char* end = text.data() + text.size();
  for (const char* at = text.data(); at != end; ++lines) {
    const void* newline = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    at = newline == nullptr ? end : static_cast<const char*>(newline) + 1;
  }
  return now_ms() - start;
}

double milliseconds(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

Run run_command(const char* output, char** command) {
  unlink(output);
  const double start = now_ms();
  const pid_t child = fork();
  if (child < 0) fail("fork");
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    execv(command[0], command);
    fail(command[0]);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) fail("wait4");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    std::fprintf(stderr, "%s failed; run it by hand to see why\n", command[0]);
    std::exit(1);
  }
  return {now_ms() - start, milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024.0};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s FILE OUTPUT COMMAND [ARGUMENT ...]\n", argv[0]);
    return 2;
  }
  const std::string_view text = map_file(argv[1]);
  std::size_t lines = 0;
  scan_ms(text, lines);
  run_command(argv[2], argv + 3);  // warms the page cache

  std::vector<double> scan;
  std::vector<double> wall;
  std::vector<double> cpu;
  std::vector<double> peak;
  for (int run = 0; run < kRuns; ++run) {
    scan.push_back(scan_ms(text, lines));
    const Run one = run_command(argv[2], argv + 3);
    wall.push_back(one.wall_ms);
    cpu.push_back(one.cpu_ms);
    peak.push_back(one.peak_mb);
  }
  const double floor = median(scan);
  const double file_mb = static_cast<double>(text.size()) / (1024.0 * 1024.0);
  std::printf(
      "lines %zu  scan %.1f ms  wall %.1f ms (x%.1f)  cpu %.1f ms (x%.1f)  beyond the file %.0f "
      "MB\n",
      lines, floor, median(wall), median(wall) / floor, median(cpu), median(cpu) / floor,
      median(peak) - file_mb);
  return 0;
}
