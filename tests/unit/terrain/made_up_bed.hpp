// A terrain whose bed or width is a function in the test.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "host/plugins/library.hpp"
#include "host/terrain/terrain.hpp"
#include "riffle/sdk.hpp"

namespace riffle::test {

class MadeUpBed {
 public:
  explicit MadeUpBed(std::function<double(double)> level) : level_(std::move(level)) {
    scene_.upper[0] = 10;
    current() = &level_;
    static const riffle_plugin* const plugins[] = {&detail::Plugin<Profile>::value, nullptr};
    static const riffle_library library{sizeof(riffle_library), RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR,
                                        sizeof(double),         "test",           plugins};
    plugin_ = read_plugins(library, "made-up").front();
    instance_ = std::make_unique<PluginInstance>(plugin_, 1, std::vector<ParameterValue>{});
    terrain_ = std::make_unique<Terrain>(scene_, instance_.get(), nullptr);
  }
  [[nodiscard]] const Terrain& terrain() const { return *terrain_; }

 private:
  static const std::function<double(double)>*& current() {
    static const std::function<double(double)>* level = nullptr;
    return level;
  }
  struct Profile {
    static constexpr auto id = "made-up", kind = "bed", version = "1.0.0", summary = "a bed of the test", source = "";
    explicit Profile(const Values&) : level(*current()) {}
    void profile(std::int64_t n, const double* x, const double*, double* value, double* slope, double*) const {
      for (std::int64_t k = 0; k < n; ++k) {
        value[k] = level(x[k]);
        if (slope != nullptr) slope[k] = (level(x[k] + 1e-6) - level(x[k] - 1e-6)) / 2e-6;
      }
    }
    std::function<double(double)> level;
  };

  std::function<double(double)> level_;
  Case scene_;
  Plugin plugin_;
  std::unique_ptr<PluginInstance> instance_;
  std::unique_ptr<Terrain> terrain_;
};

}  // namespace riffle::test
