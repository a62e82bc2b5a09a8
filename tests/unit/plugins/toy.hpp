// A small good plugin in memory, for tests to spoil one thing of.
#pragma once

#include <string>
#include <vector>

#include "host/plugins/library.hpp"
#include "riffle/fields.hpp"

namespace riffle::test {

// A drag with one parameter of each type, one pass and one vote. Members may be changed before read() is called.
struct Toy {
  riffle_parameter real = parameter("coefficient", RIFFLE_REAL, "1", 0.5, 0, 1);
  riffle_parameter integer = parameter("steps", RIFFLE_INTEGER, "1", 3, 1, 10);
  riffle_parameter word = parameter("law", RIFFLE_CHOICE, "1", 0, 0, 0);
  riffle_parameter function = parameter("roughness", RIFFLE_FUNCTION, "s.m-1/3", 0.03, 0, 0);
  std::vector<const riffle_parameter*> parameters{&real, &integer, &word, &function, nullptr};

  riffle_field own_field{sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "grain_size", "m", "size of the grains"};
  riffle_read read_velocity{sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &fields::velocity};
  riffle_read read_own{sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &own_field};
  std::vector<const riffle_read*> reads{&read_velocity, &read_own, nullptr};
  riffle_write write_drag{sizeof(riffle_write), RIFFLE_SUM, 0, 0, &fields::drag_rate};
  std::vector<const riffle_write*> writes{&write_drag, nullptr};
  riffle_pass pass{};
  std::vector<const riffle_pass*> passes{&pass, nullptr};
  riffle_vote vote{};
  std::vector<const riffle_vote*> votes{&vote, nullptr};
  std::vector<const riffle_evolved*> evolved{nullptr};
  std::vector<const riffle_iteration*> iterations{nullptr};
  riffle_plugin plugin{};
  std::vector<const riffle_plugin*> plugins{&plugin, nullptr};
  riffle_library library{sizeof(riffle_library), RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR, 8, "toy", nullptr};

  Toy() {
    word.choices = "linear|quadratic";
    word.fallback_text = "quadratic";
    pass.size = sizeof pass;
    pass.type = RIFFLE_PASS_PARTICLE;
    pass.name = "friction";
    pass.run = [](const void*, const riffle_block*, riffle_error*) noexcept -> std::int32_t { return RIFFLE_OK; };
    vote.size = sizeof vote;
    vote.name = "friction";
    vote.limit = [](const void*, const riffle_block*) noexcept { return 1.0; };
    plugin.size = sizeof plugin;
    plugin.dims = 0xE;
    plugin.id = "toy";
    plugin.kind = "drag";
    plugin.version = "1.0.0";
    plugin.summary = "a toy";
    plugin.source = "";
    plugin.create = [](std::int32_t, const riffle_value* const*, riffle_error*) noexcept -> void* {
      static char self;
      return &self;
    };
    plugin.destroy = [](void*) noexcept {};
  }
  Toy(const Toy&) = delete;
  Toy& operator=(const Toy&) = delete;

  static riffle_parameter parameter(const char* name, std::uint32_t type, const char* unit, double fallback, double min,
                                    double max) {
    riffle_parameter p{};
    p.size = sizeof p;
    p.type = type;
    p.name = name;
    p.unit = unit;
    p.doc = "a parameter of the toy";
    p.fallback = fallback;
    p.min = min;
    p.max = max;
    return p;
  }

  std::vector<Plugin> read() {
    pass.reads = reads.data();
    pass.writes = writes.data();
    vote.reads = reads.data();
    plugin.parameters = parameters.data();
    plugin.passes = passes.data();
    plugin.votes = votes.data();
    plugin.evolved = evolved.data();
    plugin.iterations = iterations.data();
    library.plugins = plugins.data();
    return read_plugins(library, "toy.so");
  }

  // What the host says to it; empty when it accepts it.
  std::vector<std::string> refusal() {
    try {
      read();
    } catch (const LibraryError& error) {
      return error.lines();
    }
    return {};
  }
};

}  // namespace riffle::test
