// Eddy viscosity by a mixing length l_m that is known at every height of an open channel, after Prandtl:
//
//   nu_t = l_m^2 |S|,   |S| = sqrt(2 S:S)                                                     Kazemi (2017) eq. 3.7
//
//   nezu-rodi     kappa z sqrt(1 - z/H), over a wake of Coles where that is given                     eqs 3.8, 2.9
//   prandtl       kappa z                                                                             eq. 2.6
//   three-layer   l_mb in a porous bed, linear in the roughness layer, as nezu-rodi above the crest   eq. 6.7
//   table         any function of place and time
//
// The height z and the depth H come from the fields `wall_distance` and `local_depth`, or, for a bed and a depth that are
// known, from levels, which costs less and does not see single particles that splash. Walls of particles lie half a spacing
// below the bed that they make, and `wall_distance` is measured to them: prefer levels over beds of particles.
// Damping after van Driest is for smooth walls whose sublayer is resolved (his printed conditions for both branches of eq.
// 2.7 are the same; the outer branch, a constant length, is left out).
// Not in it: the history of the flow, separation, waves: the length is that of uniform flow.
#include <cmath>
#include <riffle/height.hpp>
#include <riffle/mixing_length.hpp>
#include <riffle/sdk.hpp>
#include <stdexcept>
#include <vector>

namespace f = riffle::fields;

struct MixingLength {
  static constexpr auto id = "mixing-length", kind = "turbulence", version = "1.0.0";
  static constexpr auto summary = "Eddy viscosity of open channels by a mixing length over the depth";
  static constexpr auto source =
      "Prandtl (1925); Nezu & Rodi (1986); van Driest (1956); Kazemi (2017) eqs 2.6-2.9, 3.7, 3.8, 6.7";
  static constexpr auto leaves_out = "history of the flow, separation, waves";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;

  enum Profile { nezu_rodi, prandtl, three_layer, table };  // in the order of the words
  static constexpr riffle_parameter parameters[] = {
      riffle::choice("profile", "nezu-rodi|prandtl|three-layer|table", "nezu-rodi",
                     "how the length varies with height"),
      riffle::choice("heights", "fields|levels", "fields",
                     "fields: wall_distance and local_depth; levels: bed_level and depth"),
      riffle::function("bed_level", "m", 0, "level of the bed; with fields it only places trough and crest"),
      riffle::real("depth", "m", 0, 0, 1e4, "levels: depth of the water above bed_level"),
      riffle::real("kappa", "1", 0.41, 0, 2, "nezu-rodi, prandtl: slope of the length at the bed"),
      riffle::real("coles", "1", 0, 0, 2, "nezu-rodi: wake parameter Pi; 0 in eq. 3.8, 0.2 after Nezu & Rodi"),
      riffle::choice("damping", "none|van-driest", "none", "near smooth walls, with shear_velocity"),
      riffle::real("shear_velocity", "m.s-1", 0, 0, 100, "van-driest: u*, the root of g H S0"),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "van-driest: nu of the water"),
      riffle::real("trough", "m", 0, -1e6, 1e6, "three-layer: level z_t"),
      riffle::real("crest", "m", 0, -1e6, 1e6, "three-layer: level z_c"),
      riffle::real("length_in_bed", "m", 0.002, 0, 10, "three-layer: l_mb"),
      riffle::real("length_offset", "m", 0, -100, 100,
                   "three-layer: Delta z_0, where the length begins to grow, above trough"),
      riffle::real("kappa_rough", "1", 0.27, 0, 2, "three-layer: slope in the roughness layer"),
      riffle::real("kappa_free", "1", 0.22, 0, 2, "three-layer: slope above the crest"),
      riffle::function("length", "m", 0, "table: l_m of place and time, for instance of z from a CSV file")};

  struct FromFields {
    static constexpr auto pass_name = "mixing length from fields";
    static constexpr auto when = "heights=fields";
    static constexpr riffle_read reads[] = {riffle::at_i(f::strain_rate), riffle::at_i(f::position),
                                            riffle::at_i(f::wall_distance), riffle::at_i(f::local_depth)};
    static constexpr riffle_write writes[] = {riffle::set(f::eddy_viscosity)};
    static void run(const MixingLength& s, const riffle::Block& b) {
      s.set_viscosity(
          b, [&](std::size_t k) { return b.in(2)[k]; }, [&](std::size_t k) { return b.in(3)[k]; });
    }
  };
  struct FromLevels {
    static constexpr auto pass_name = "mixing length from levels";
    static constexpr auto when = "heights=levels";
    static constexpr riffle_read reads[] = {riffle::at_i(f::strain_rate), riffle::at_i(f::position)};
    static constexpr riffle_write writes[] = {riffle::set(f::eddy_viscosity)};
    static void run(const MixingLength& s, const riffle::Block& b) {
      const std::vector<double> height = riffle::heights_above(*s.bed_level, b, 1);
      s.set_viscosity(
          b, [&](std::size_t k) { return height[k]; }, [&](std::size_t) { return s.depth; });
    }
  };
  using passes = riffle::Passes<FromFields, FromLevels>;

  explicit MixingLength(const riffle::Values& v)
      : law(static_cast<Profile>(v.number("profile"))),
        bed_level(v.function("bed_level")),
        length(v.function("length")),
        depth(v.number("depth")),
        kappa(v.number("kappa")),
        coles(v.number("coles")),
        shear_velocity(v.word("damping") == "van-driest" ? v.number("shear_velocity") : 0),
        viscosity(v.number("viscosity")),
        layers{v.number("trough"),        v.number("crest"),       v.number("length_offset"),
               v.number("length_in_bed"), v.number("kappa_rough"), v.number("kappa_free")} {
    if (v.word("heights") == "levels" && !(depth > 0)) {
      throw std::invalid_argument("heights = \"levels\" needs the depth of the water above bed_level, got 0 m");
    }
    if (v.word("damping") == "van-driest" && !(shear_velocity > 0 && viscosity > 0)) {
      throw std::invalid_argument("damping = \"van-driest\" needs a shear_velocity and a viscosity above 0");
    }
    if (law == three_layer && !(layers.trough + layers.offset < layers.crest)) {
      throw std::invalid_argument("profile = \"three-layer\" needs trough + length_offset below crest");
    }
    if (law == table && !v.given("length")) {
      throw std::invalid_argument("profile = \"table\" needs the function length");
    }
  }

  // nu_t from |S| as in(0) and the position as in(1).
  template <class Height, class Depth>
  void set_viscosity(const riffle::Block& b, Height height_of, Depth depth_of) const {
    const auto n = static_cast<std::size_t>(b.size());
    std::vector<double> l(n), bed;
    if (law == table) {
      length->evaluate(length->context, b.size(), b.in(1, 0), b.dim() == 3 ? b.in(1, 1) : nullptr, b.in(1, b.dim() - 1),
                       b.time(), l.data());
    } else if (law == three_layer) {  // its levels become heights
      bed.resize(n);
      bed_level->evaluate(bed_level->context, b.size(), b.in(1, 0), b.dim() == 3 ? b.in(1, 1) : nullptr, nullptr,
                          b.time(), bed.data());
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double z = height_of(k), water = depth_of(k);
      if (law == nezu_rodi) l[k] = riffle::mixing_length::nezu_rodi(z, water, kappa, coles);
      if (law == prandtl) l[k] = riffle::mixing_length::prandtl(z, water, kappa);
      if (law == three_layer) l[k] = layers(z + bed[k], water + bed[k]);
      if (shear_velocity > 0) l[k] *= riffle::mixing_length::van_driest(z, shear_velocity, viscosity);
      b.out(0)[k] = l[k] * l[k] * b.in(0)[k];
    }
  }

  Profile law;
  const riffle_function *bed_level, *length;
  double depth, kappa, coles, shear_velocity, viscosity;
  riffle::mixing_length::ThreeLayer layers;
};

RIFFLE_PLUGIN(MixingLength)
