#include "host/output/build_info.hpp"

#include <sched.h>

#include <fstream>
#include <thread>

namespace riffle {

std::string riffle_version() {
  return RIFFLE_VERSION;
}

std::string riffle_build() {
#if defined(__clang__)
  std::string text = "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
                     std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
  std::string text = "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." +
                     std::to_string(__GNUC_PATCHLEVEL__);
#else
  std::string text = "unknown compiler";
#endif
  text += std::string(", ") + RIFFLE_BUILD_TYPE;
  if (RIFFLE_IS_NATIVE) text += ", native vector width";
  return text;
}

Machine this_machine() {
  Machine machine;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; machine.processor.empty() && std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) machine.processor = line.substr(colon + 2);
  }
  if (machine.processor.empty()) machine.processor = "unknown";
  cpu_set_t usable;
  CPU_ZERO(&usable);
  machine.cores = sched_getaffinity(0, sizeof usable, &usable) == 0
                      ? CPU_COUNT(&usable)
                      : static_cast<int>(std::thread::hardware_concurrency());
  return machine;
}

}  // namespace riffle
