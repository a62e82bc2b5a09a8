#include "host/terrain/terrain_fields.hpp"

#include <algorithm>
#include <riffle/sdk.hpp>
#include <vector>

#include "host/plugins/call.hpp"
#include "host/terrain/smoothed_bed.hpp"

namespace riffle {

namespace {

namespace f = riffle::fields;

// Of a plan view the bed has x and y; in the vertical plane it is a line.
const double* second_axis(const Block& b) {
  return b.dim() == 3 ? b.in(0, 1) : nullptr;
}

// Water, and the buffers beyond open ends, whose bed and width their neighbours see.
constexpr std::uint32_t with_ends = RIFFLE_FLUID | RIFFLE_INFLOW | RIFFLE_OUTFLOW;

struct BedLevel {
  static constexpr auto pass_name = "bed level";
  static constexpr std::uint32_t targets = with_ends;
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {set(f::bed_level)};
  static void run(const TerrainFields& t, const Block& b) {
    t.terrain().bed(b.size(), b.in(0), second_axis(b), b.out(0), nullptr, nullptr);
  }
};

struct BedSlope {
  static constexpr auto pass_name = "bed slope";
  static constexpr std::uint32_t targets = with_ends;
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {set(f::bed_slope)};
  static void run(const TerrainFields& t, const Block& b) {
    std::vector<double> level(static_cast<std::size_t>(b.size()));
    double* across = b.dim() == 3 ? b.out(0, 1) : nullptr;
    t.terrain().bed(b.size(), b.in(0), second_axis(b), level.data(), b.out(0, 0), across);
    if (b.dim() > 1) std::fill_n(b.out(0, b.dim() - 1), b.size(), 0.0);
  }
};

struct SmoothedBedLevel {
  static constexpr auto pass_name = "smoothed bed level";
  static constexpr riffle_read reads[] = {at_i(f::position), at_i(f::smoothing_length)};
  static constexpr riffle_write writes[] = {set(f::smoothed_bed_level)};
  static void run(const TerrainFields& t, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = t.smoothed().level(b.in(0)[k], b.in(1)[k]);
  }
};

struct SmoothedBedSlope {
  static constexpr auto pass_name = "smoothed bed slope";
  static constexpr riffle_read reads[] = {at_i(f::position), at_i(f::smoothing_length)};
  static constexpr riffle_write writes[] = {set(f::smoothed_bed_slope)};
  static void run(const TerrainFields& t, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = t.smoothed().slope(b.in(0)[k], b.in(1)[k]);
  }
};

struct SmoothedBedCurvature {
  static constexpr auto pass_name = "smoothed bed curvature";
  static constexpr riffle_read reads[] = {at_i(f::position), at_i(f::smoothing_length)};
  static constexpr riffle_write writes[] = {set(f::smoothed_bed_curvature)};
  static void run(const TerrainFields& t, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = t.smoothed().curvature(b.in(0)[k], b.in(1)[k]);
  }
};

struct WaterLevel {
  static constexpr auto pass_name = "water level";
  static constexpr std::uint32_t targets = with_ends;
  static constexpr riffle_read reads[] = {at_i(f::depth), at_i(f::bed_level)};
  static constexpr riffle_write writes[] = {set(f::water_level)};
  static void run(const TerrainFields&, const Block& b) { RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] + b.in(1)[k]; }
};

struct ChannelWidth {
  static constexpr auto pass_name = "channel width";
  static constexpr std::uint32_t targets = with_ends;
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {set(f::channel_width), set(f::width_slope)};
  static void run(const TerrainFields& t, const Block& b) { t.terrain().width(b.size(), b.in(0), b.out(0), b.out(1)); }
};

// For initial passes, such as one that makes a volume of depth and width.
struct InitialWidth : ChannelWidth {
  static constexpr auto pass_name = "channel width at t = 0";
  static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
};

template <class... Pass>
const riffle_plugin* table_of() {
  static constexpr std::array<const riffle_pass*, sizeof...(Pass) + 1> passes{
      &detail::PassTable<TerrainFields, Pass>::value..., nullptr};
  static const riffle_plugin plugin = [] {
    riffle_plugin p{};
    p.size = sizeof p;
    p.dims = 0xE;
    p.id = "host";
    p.kind = TerrainFields::kind;
    p.version = "1.0.0";
    p.summary = "fields that the host makes of bed and width";
    p.source = "";
    p.leaves_out = "";
    p.passes = passes.data();
    return p;
  }();
  return &plugin;
}

}  // namespace

TerrainFields::TerrainFields(const Terrain& terrain, const Case& scene, const PluginInstance* kernel)
    : terrain_(terrain), scene_(scene), kernel_(kernel) {}
TerrainFields::~TerrainFields() = default;

ActivePlugin TerrainFields::as_plugin() const {
  const bool smooth = kernel_ != nullptr && scene_.dimension == 1;
  const riffle_plugin* table =
      terrain_.has_bed() && terrain_.has_width()
          ? (smooth ? table_of<BedLevel, BedSlope, SmoothedBedLevel, SmoothedBedSlope, SmoothedBedCurvature, WaterLevel,
                               ChannelWidth, InitialWidth>()
                    : table_of<BedLevel, BedSlope, WaterLevel, ChannelWidth, InitialWidth>())
      : terrain_.has_bed()
          ? (smooth
                 ? table_of<BedLevel, BedSlope, SmoothedBedLevel, SmoothedBedSlope, SmoothedBedCurvature, WaterLevel>()
                 : table_of<BedLevel, BedSlope, WaterLevel>())
      : terrain_.has_width() ? table_of<ChannelWidth, InitialWidth>()
                             : table_of<>();
  return {"host", "host", "host", table, this, {}, true};
}

void TerrainFields::prepare(double smallest_spacing, double largest_spacing) {
  if (kernel_ == nullptr || !terrain_.has_bed() || scene_.dimension != 1) return;
  riffle_kernel about{};
  about.size = sizeof about;
  kernel_->table().kernel(kernel_->self(), &about);
  const auto kernel = [instance = kernel_](std::int64_t n, const double* r, const double* inverse_l, double* w) {
    double* out[RIFFLE_KERNEL_OUTPUTS] = {w};
    if (may_throw(instance->table().evaluate_kernel)(instance->self(), n, r, inverse_l, RIFFLE_W, out) != RIFFLE_OK)
      throw std::runtime_error(instance->name() + " fails to smooth the bed");
  };
  // Supports shrink where water deepens; a sixteenth of the smallest at t = 0 leaves room for that.
  const double length = scene_.smoothing_ratio * smallest_spacing;
  const double margin = 8 * about.support * scene_.smoothing_ratio * largest_spacing;
  smoothed_ = std::make_unique<SmoothedBed>(terrain_, scene_.lower[0] - margin, scene_.upper[0] + margin, length / 16,
                                            kernel, about.support, about.integral);
}

}  // namespace riffle
