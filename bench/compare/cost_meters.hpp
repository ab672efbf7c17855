// The cost of a run: processor time, wall time, and the peak of resident memory.
#pragma once

#include <vector>

namespace beespace::compare {

// Since its construction. Processor time is that of all threads of the process.
class Stopwatch {
 public:
  Stopwatch();
  [[nodiscard]] double cpu_ms() const;
  [[nodiscard]] double wall_ms() const;

 private:
  double cpu_start_ms_;
  double wall_start_ms_;
};

// The median; of an even number the greater of the two in the middle.
double median(std::vector<double> values);

// The most resident memory that the process ever had, in megabytes (10^6 bytes; Linux only).
double peak_of_process_mb();

// How far resident memory rises above what it was at construction (Linux only).
class MemoryMeter {
 public:
  MemoryMeter();
  [[nodiscard]] double peak_mb() const;

 private:
  double start_mb_;
};

}  // namespace beespace::compare
