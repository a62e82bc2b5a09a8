#include "host/schedule/neighbourhood.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/schedule/run_error.hpp"

namespace riffle {

namespace {
constexpr std::int64_t builds_between_sorts = 8;  // order in memory decays slowly; sorting costs a third of a build

// Particles that have flown apart or are no numbers cannot be searched: the run has failed, not the program.
template <class Search>
auto searched(const Search& search) {
  try {
    return search();
  } catch (const std::runtime_error& error) {
    throw RunError(error.what());
  }
}

bool same(const NeighbourRequest& a, const NeighbourRequest& b) {
  return a.reach == b.reach && a.targets == b.targets && a.sources == b.sources;
}
}  // namespace

Neighbourhood::Neighbourhood(ParticleStore& store, double kappa, double skin,
                             std::function<void(std::vector<Image>&)> make_images)
    : store_(store), kappa_(kappa), skin_(store.dim() == 1 ? 0.0 : skin), make_images_(std::move(make_images)) {}

void Neighbourhood::require(const NeighbourRequest& request) {
  for (const auto& entry : lists_) {
    if (same(entry->request, request)) return;
  }
  lists_.push_back(std::make_unique<Entry>());
  lists_.back()->request = request;
  valid_ = false;
}

void Neighbourhood::forget_requests() {
  lists_.clear();
  valid_ = false;
}

const NeighbourList& Neighbourhood::list(const NeighbourRequest& request) const {
  for (const auto& entry : lists_) {
    if (!same(entry->request, request)) continue;
    if (!entry->current) {
      searched([&] { riffle::build(view(), kappa_, skin_, request, entry->list); });
      entry->current = true;
    }
    return entry->list;
  }
  throw std::logic_error("a neighbour list was asked for that no pass declares");
}

void Neighbourhood::reach(std::vector<double>& out) const {
  out.resize(static_cast<std::size_t>(store_.owned()));
  const double* l = store_.data("smoothing_length");
  const double factor = kappa_ * (1 + skin_);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = factor * l[i];
}

ParticleView Neighbourhood::view() const {
  ParticleView view;
  view.dim = store_.dim();
  view.owned = store_.owned();
  view.all = store_.all();
  for (int c = 0; c < store_.dim(); ++c) view.x[c] = store_.data("position", c);
  view.l = store_.data("smoothing_length");
  view.role = role_.empty() ? nullptr : role_.data();
  return view;
}

bool Neighbourhood::still_valid() const {
  if (!valid_ || store_.dim() == 1) return false;
  return std::all_of(lists_.begin(), lists_.end(), [&](const auto& entry) { return entry->check.valid(view()); });
}

bool Neighbourhood::prepare() {
  if (still_valid()) return false;
  if (store_.dim() == 1) sort_line();
  if (store_.dim() > 1 && state_.builds % builds_between_sorts == 0) sort();
  const auto n = static_cast<std::size_t>(store_.owned());
  if (store_.dim() > 1) {  // in one dimension the lists follow from the current state
    for (int c = 0; c < store_.dim(); ++c)
      state_.x[c].assign(store_.data("position", c), store_.data("position", c) + n);
    state_.l.assign(store_.data("smoothing_length"), store_.data("smoothing_length") + n);
  }
  ++state_.builds;
  build();
  return true;
}

// Keeps the particles of each role in ascending x; they seldom overtake each other.
void Neighbourhood::sort_line() {
  const double* x = store_.data("position");
  for (int r = 0; r < role_count; ++r) {
    if (std::is_sorted(x + store_.role_begin(r), x + store_.role_begin(r + 1))) continue;
    sort();
    return;
  }
}

void Neighbourhood::sort() {
  store_.resize_images(0);
  role_.clear();
  if (store_.role_begin(1) != store_.owned()) {
    role_.resize(static_cast<std::size_t>(store_.owned()));
    for (int r = 0; r < role_count; ++r) {
      std::fill(role_.begin() + store_.role_begin(r), role_.begin() + store_.role_begin(r + 1),
                static_cast<std::uint8_t>(r));
    }
  }
  const double* l = store_.data("smoothing_length");
  const double largest = store_.owned() > 0 ? *std::max_element(l, l + store_.owned()) : 0;
  if (largest > 0) store_.permute(searched([&] { return cell_order(view(), kappa_ * largest); }));
}

void Neighbourhood::build() {
  images_.clear();
  store_.resize_images(0);
  if (make_images_) make_images_(images_);
  store_.resize_images(static_cast<std::int64_t>(images_.size()));
  refresh_images(images_, store_, store_.at("position"));
  refresh_images(images_, store_, store_.at("smoothing_length"));
  role_.clear();
  if (store_.role_begin(1) != store_.owned()) {
    role_.resize(static_cast<std::size_t>(store_.all()));
    for (int r = 0; r < role_count; ++r) {
      std::fill(role_.begin() + store_.role_begin(r), role_.begin() + store_.role_begin(r + 1),
                static_cast<std::uint8_t>(r));
    }
    for (std::size_t k = 0; k < images_.size(); ++k)
      role_[static_cast<std::size_t>(store_.owned()) + k] = role_[static_cast<std::size_t>(images_[k].origin)];
  }
  for (auto& entry : lists_) {
    entry->current = false;
    if (store_.dim() == 1) continue;
    searched([&] { riffle::build(view(), kappa_, skin_, entry->request, entry->list); });
    entry->check.remember(view(), kappa_, skin_, entry->request);
    entry->current = true;
  }
  find_roles_between();
  valid_ = true;
}

void Neighbourhood::find_roles_between() {
  present_ = between_ = 0;
  if (store_.dim() != 1) return;
  const double* x = store_.data("position");
  const std::int64_t water = store_.role_begin(1);
  if (water > 0) present_ = RIFFLE_FLUID;
  for (std::int64_t i = water; i < store_.all(); ++i) {
    const std::uint32_t role = 1u << (role_.empty() ? 0u : role_[static_cast<std::size_t>(i)]);
    present_ |= role;
    if (water > 0 && x[i] >= x[0] && x[i] <= x[water - 1]) between_ |= role;
  }
}

bool Neighbourhood::on_a_line(const NeighbourRequest& request) const {
  return store_.role_begin(1) > 0 && (request.targets & present_) == RIFFLE_FLUID &&
         (request.sources & RIFFLE_FLUID) != 0 && (request.sources & between_) == 0;
}

NeighbourhoodState Neighbourhood::state() const {
  if (valid_) return state_;
  NeighbourhoodState void_lists;
  void_lists.builds = state_.builds;
  return void_lists;
}

void Neighbourhood::restore(const NeighbourhoodState& state) {
  state_ = state;
  const auto n = static_cast<std::size_t>(store_.owned());
  if (state_.builds == 0 || state_.l.size() != n) return;
  std::vector<double> now[3], l_now(store_.data("smoothing_length"), store_.data("smoothing_length") + n);
  for (int c = 0; c < store_.dim(); ++c) {
    double* x = store_.data("position", c);
    now[c].assign(x, x + n);
    std::copy(state_.x[c].begin(), state_.x[c].end(), x);
  }
  std::copy(state_.l.begin(), state_.l.end(), store_.data("smoothing_length"));
  build();
  for (int c = 0; c < store_.dim(); ++c) std::copy(now[c].begin(), now[c].end(), store_.data("position", c));
  std::copy(l_now.begin(), l_now.end(), store_.data("smoothing_length"));
}

std::size_t Neighbourhood::bytes() const {
  std::size_t sum = images_.size() * sizeof(Image) + role_.size() +
                    (state_.x[0].size() + state_.x[1].size() + state_.x[2].size() + state_.l.size()) * sizeof(double);
  for (const auto& entry : lists_) {
    sum += entry->list.begin.size() * 8 + entry->list.count.size() * 4 +
           static_cast<std::size_t>(entry->list.neighbour.size()) * 4;
  }
  return sum;
}

}  // namespace riffle
