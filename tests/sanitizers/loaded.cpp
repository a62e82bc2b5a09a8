// Mistakes for the sanitizers to find, and one sound parallel loop that they must let pass.
#include <limits>
#include <memory>
#include <vector>

extern "C" {

double reads_past_the_end(int n) {
  const auto values = std::make_unique<double[]>(static_cast<std::size_t>(n));
  return values[static_cast<std::size_t>(n)];
}

double forgets_memory(int n) {  // again and again: the last pointer may still lie on the stack
  double sum = 0;
  for (int time = 0; time < 4; ++time) {
    const auto* volatile forgotten = new std::vector<double>(static_cast<std::size_t>(n), 1.0);
    sum += forgotten->front();
    forgotten = nullptr;
  }
  return sum;
}

double overflows_an_integer(int n) {
  volatile int largest = std::numeric_limits<int>::max();
  return largest + n;
}

double races(int n) {
  double sum = 0;
#pragma omp parallel for num_threads(4)
  for (int i = 0; i < n; ++i) sum += i;
  return sum;
}

double sums_soundly(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  double sum = 0;
#pragma omp parallel num_threads(4)
  {
#pragma omp for schedule(dynamic, 16)
    for (int i = 0; i < n; ++i) values[static_cast<std::size_t>(i)] = i;
#pragma omp for reduction(+ : sum)
    for (int i = 0; i < n; ++i) sum += values[static_cast<std::size_t>(n - 1 - i)];
  }
  return sum;
}
}
