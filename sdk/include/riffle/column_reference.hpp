// What the references of uniform flow share: two of discharge, level and slope, and the profile as a reference solution.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "riffle/column.hpp"
#include "riffle/fields.hpp"
#include "riffle/services.hpp"

namespace riffle {

struct ChannelState {
  std::optional<double> discharge, level, slope;  // m2/s, m, 1
  const char* level_name = "level";               // as the manifest calls it
  double level_datum = 0;                         // m: subtracted from a level before it is shown
};

// The flow of two of the three, none when nothing is given: then there is nothing to compare with. Throws
// std::invalid_argument with one sentence: all three, with what each two of them would give for the third; one; or what the
// column says.
inline std::optional<ColumnFlow> channel_flow(const Column& column, const ChannelState& s) {
  const std::string names = std::string("discharge, ") + s.level_name + " and slope";
  const int given = (s.discharge ? 1 : 0) + (s.level ? 1 : 0) + (s.slope ? 1 : 0);
  if (given == 0) return std::nullopt;
  if (given == 1) throw std::invalid_argument("channel: of " + names + " two must be given");
  if (given == 3) {
    std::ostringstream text;
    text.precision(4);
    text << "channel: " << names << " are all given; give two. With this bed: ";
    const auto either = [&](const char* pair, const char* third, const char* unit, auto value) {
      text << pair << " -> " << third << " = ";
      try {
        text << value();
      } catch (const std::invalid_argument&) {
        text << "none";
      }
      text << unit;
    };
    const std::string level = s.level_name;
    either(("(" + level + ", slope)").c_str(), "discharge", " m2/s; ",
           [&] { return ColumnFlow::of_slope(column, *s.level, *s.slope).discharge(); });
    either("(discharge, slope)", s.level_name, " m; ",
           [&] { return ColumnFlow::of_slope_and_discharge(column, *s.slope, *s.discharge).level() - s.level_datum; });
    either(("(discharge, " + level + ")").c_str(), "slope", "",
           [&] { return ColumnFlow::of_discharge(column, *s.level, *s.discharge).slope(); });
    throw std::invalid_argument(text.str());
  }
  if (!s.discharge) return ColumnFlow::of_slope(column, *s.level, *s.slope);
  if (!s.slope) return ColumnFlow::of_discharge(column, *s.level, *s.discharge);
  return ColumnFlow::of_slope_and_discharge(column, *s.slope, *s.discharge);
}

// From rest a channel comes to its mean velocity U as U tanh(g S0 t / U): says so when the run ends before, unless it begins
// with the velocities of the reference. `end` [s], 0: not known.
template <class Plugin>
void warn_of_relaxation(const riffle_services& scene, double mean_velocity, double force, double end) {
  if (!has_lattice(scene) || scene.starts_from_reference != 0 || !(end > 0)) return;
  const double relaxation = mean_velocity / (2 * force), missing = 1 - std::tanh(end / (2 * relaxation));
  if (!(missing > 0.01)) return;
  std::ostringstream text;
  text.precision(2);
  text << "time.end is " << end / relaxation << " relaxation times (" << relaxation
       << " s): from rest the mean velocity will be " << 100 * missing
       << " % low; begin with velocity = \"reference\", or run to " << 5.3 * relaxation << " s";
  warn<Plugin>(scene, text.str());
}

// Names of the shear stresses that equation sets of weakly compressible flow offer to outputs. In uniform flow all of it is
// carried by viscosity and eddies, and pressure forces between particles carry none.
inline constexpr riffle_field modelled_shear_stress{sizeof(riffle_field),
                                                    RIFFLE_SCALAR,
                                                    0,
                                                    0,
                                                    "modelled_shear_stress",
                                                    "kg.m-1.s-2",
                                                    "rho (nu + nu_t) (du/dz + dw/dx)"};
inline constexpr riffle_field virial_shear_stress{
    sizeof(riffle_field),
    RIFFLE_SCALAR,
    0,
    0,
    "virial_shear_stress",
    "kg.m-1.s-2",
    "shear stress that pressure forces between particles carry: 0 in a fluid"};
inline constexpr const riffle_field* column_gives[] = {&fields::velocity,      &fields::pressure,
                                                       &fields::strain_rate,   &fields::eddy_viscosity,
                                                       &modelled_shear_stress, &virial_shear_stress};

// Rows of column_gives, for points in a frame with x along the bed: velocity relative to its mean above the crest, pressure
// (hydrostatic) and stresses to their values at the bottom, the other two to u* / H and u* H. Defined in the water.
class ColumnProfile {
 public:
  ColumnProfile(ColumnFlow flow, const Column& column, double density)
      : flow_(std::move(flow)),
        bottom_(column.bottom),
        depth_(flow_.level() - column.bottom),
        density_(density),
        gravity_(column.gravity),
        mean_(flow_.mean_velocity(column.crest(), flow_.level())),
        porosity_(column.porosity) {}
  [[nodiscard]] const ColumnFlow& flow() const { return flow_; }
  [[nodiscard]] double mean_velocity() const { return mean_; }

  void write(const riffle_points& p, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const int dim = p.dim;
    const double slope = flow_.slope(), friction = std::sqrt(gravity_ * slope * depth_);
    const double normal = density_ * gravity_ * std::sqrt(std::max(1 - slope * slope, 0.0));
    for (std::int64_t k = 0; k < p.n; ++k) {
      const double z = p.x[dim - 1] != nullptr ? p.x[dim - 1][k] : bottom_ - 1;
      defined[k] = z >= bottom_ && z <= flow_.level() ? 1 : 0;
      for (int c = 0; c < dim; ++c) {
        values[c][k] = c == 0 ? flow_.velocity(z) : 0;
        scales[c][k] = mean_;
      }
      const double phi = porosity_ ? porosity_(z) : 1;
      const double rows[] = {normal * (flow_.level() - z), std::abs(flow_.gradient(z)), flow_.eddy_viscosity(z),
                             density_ * flow_.stress(z) / phi, 0.0};
      const double sizes[] = {normal * depth_, friction / depth_, friction * depth_, density_ * friction * friction,
                              density_ * friction * friction};
      for (int r = 0; r < 5; ++r) {
        values[dim + r][k] = rows[r];
        scales[dim + r][k] = sizes[r];
      }
    }
  }

 private:
  ColumnFlow flow_;
  double bottom_, depth_, density_, gravity_, mean_;
  std::function<double(double)> porosity_;
};

}  // namespace riffle
