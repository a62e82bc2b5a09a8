// Porous regions in the vertical plane, one line each, with a transition of given thickness at their outlines:
//
//   regions = """
//   0.49: 0.30 0, 0.59 0, 0.59 0.37, 0.30 0.37        # porosity: corners as "x z" in metres, all around
//   """
//   phi = 1 - sum over regions of (1 - phi_region) S(1/2 + d / thickness),   S(t) = t^2 (3 - 2 t) on [0, 1]
//
// d is the distance from the outline, above 0 inside. Kazemi (2017) averages phi with a smoothing function about the outline
// (eqs 4.54, 4.59), which is this within 2 %. Edges on a face of the domain have no transition: the rock goes on behind it.
// Two regions with a common edge pass from the one porosity to the other; porosity without a transition drives currents
// in water at rest, so the thickness is above 0: take the grain diameter, and no less than about a particle spacing.
// Not in it: regions that move; three dimensions.
#include <riffle/polygon.hpp>
#include <riffle/porosity.hpp>
#include <riffle/services.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace f = riffle::fields;

namespace {

struct Region {
  riffle::Polygon outline;
  double porosity;
  std::vector<char> inner;  // per edge: not on a face of the domain
};

[[noreturn]] void refuse(std::size_t number, const std::string& what) {
  throw std::invalid_argument("region " + std::to_string(number) + ": " + what);
}

Region read_region(std::string text, std::size_t number) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) refuse(number, "must be \"porosity: x z, x z, x z, ...\", got \"" + text + '"');
  std::istringstream head(text.substr(0, colon));
  double phi = 0;
  if (!(head >> phi) || !(head >> std::ws).eof() || !(phi > 0 && phi <= 1))
    refuse(number, "porosity must be above 0 and at most 1, got \"" + text.substr(0, colon) + '"');
  std::vector<riffle::PlanePoint> corners;
  std::istringstream list(text.substr(colon + 1));
  for (std::string one; std::getline(list, one, ',');) {
    std::istringstream pair(one);
    riffle::PlanePoint p{};
    if (!(pair >> p[0] >> p[1]) || !(pair >> std::ws).eof())
      refuse(number, "a corner must be two numbers, x and z in metres, got \"" + one + '"');
    corners.push_back(p);
  }
  if (corners.size() < 3) refuse(number, "needs at least 3 corners, got " + std::to_string(corners.size()));
  Region region{riffle::Polygon(corners), phi, {}};
  if (region.outline.crosses_itself()) refuse(number, "the polygon crosses itself; name its corners all around");
  if (!(region.outline.area() > 0)) refuse(number, "the polygon has no area");
  return region;
}

}  // namespace

struct Regions {
  static constexpr auto id = "regions", kind = "porosity", version = "1.0.0";
  static constexpr auto summary = "Porous regions by polygon, with a smooth transition at their outlines";
  static constexpr auto source = "Kazemi (2017) eqs 4.54, 4.59, with a smoothstep for the weighting function";
  static constexpr auto leaves_out = "regions that move; three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr riffle_parameter parameters[] = {
      riffle::text("regions", "", "one line per region: \"porosity: x z, x z, x z, ...\", corners in metres",
                   RIFFLE_REQUIRED),
      riffle::real("thickness", "m", 0.01, 0, 1e3, "of the transition about each outline: the grain diameter d_s",
                   RIFFLE_ABOVE_MIN)};
  using passes = riffle::PorosityPasses<Regions>;

  explicit Regions(const riffle::Values& v) : thickness(v.number("thickness")) {
    std::string lines = v.word("regions");
    for (char& c : lines) c = c == ';' ? '\n' : c;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
      line = line.substr(0, line.find('#'));
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      regions.push_back(read_region(line, regions.size() + 1));
    }
    for (std::size_t k = 0; k < regions.size(); ++k) {
      for (std::size_t m = 0; m < k; ++m) {
        if (regions[k].outline.overlaps(regions[m].outline))
          refuse(k + 1, "overlaps region " + std::to_string(m + 1) + "; regions may share edges, not area");
      }
    }
  }

  void connect(const riffle_services& s) {
    domain.services = &s;
    riffle::require_within_domain(s, "thickness", thickness);
    if (riffle::has_lattice(s) && thickness < s.spacing) {
      std::ostringstream text;
      text << "the transition of " << thickness << " m is thinner than the spacing of the particles, " << s.spacing
           << " m: porosity that jumps drives currents in water at rest";
      riffle::warn<Regions>(s, text.str());
    }
    for (Region& region : regions) {
      if (riffle::has_lattice(s)) require_that_it_meets_the_domain(region, s);
      region.inner.assign(region.outline.edges(), 1);
      for (std::size_t k = 0; k < region.outline.edges(); ++k) {
        for (std::size_t a = 0; a < 2; ++a) {
          const double little = 1e-9 * (s.high[a] - s.low[a]);
          const double p = region.outline.from(k)[a], q = region.outline.to(k)[a];
          const bool below = p <= s.low[a] + little && q <= s.low[a] + little;
          const bool above = p >= s.high[a] - little && q >= s.high[a] - little;
          if (below || above) region.inner[k] = 0;
        }
      }
    }
  }

  void require_that_it_meets_the_domain(const Region& region, const riffle_services& s) const {
    const auto number = static_cast<std::size_t>(&region - regions.data()) + 1;
    for (std::size_t a = 0; a < 2; ++a) {
      double low = region.outline.from(0)[a], high = low;
      for (std::size_t k = 0; k < region.outline.edges(); ++k) {
        low = std::min(low, region.outline.from(k)[a]), high = std::max(high, region.outline.from(k)[a]);
      }
      if (low < s.high[a] && high > s.low[a] && high - low < 100 * (s.high[a] - s.low[a])) continue;
      std::ostringstream text;
      text << "its "
           << "xz"[a] << " from " << low << " to " << high << " does not fit the domain, " << s.low[a] << " to "
           << s.high[a] << " m; corners are in metres";
      refuse(number, text.str());
    }
  }

  [[nodiscard]] double porosity(const std::array<double, 3>& x) const {
    double phi = 1;
    for (const Region& region : regions) {
      const riffle::PlanePoint p{x[0], x[1]};
      if (region.outline.beyond(p, 0.5 * thickness)) continue;
      const auto counts = [&](std::size_t k) { return region.inner.empty() || region.inner[k] != 0; };
      const double from = region.outline.distance(p, counts), d = region.outline.contains(p) ? from : -from;
      const double t = d > thickness ? 1 : d < -thickness ? 0 : std::clamp(0.5 + d / thickness, 0.0, 1.0);
      phi -= (1 - region.porosity) * t * t * (3 - 2 * t);
    }
    return phi;
  }
  double thickness;
  std::vector<Region> regions;
  riffle::PorousDomain domain;
};

RIFFLE_PLUGIN(Regions)
