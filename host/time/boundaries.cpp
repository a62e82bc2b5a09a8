#include "host/time/boundaries.hpp"

#include <algorithm>
#include <map>

namespace riffle {

// What the editor's functions work on during one call of one plugin.
struct Boundaries::Context {
  ParticleStore* store = nullptr;
  Evaluator* evaluator = nullptr;
  std::vector<Image>* images = nullptr;
  std::int64_t count = 0, added = 0;
  std::map<std::int64_t, std::uint32_t> retagged;  // and the roles of added particles
  std::vector<char> removed;
  std::vector<std::int64_t> like;  // of added particles
  bool edited = false;
};

namespace {

template <class T>
T& context_of(void* p) {
  return *static_cast<T*>(p);
}

int role_index(std::uint32_t bit) {
  int r = 0;
  while (r < role_count && (1u << r) != bit) ++r;
  return r;
}

}  // namespace

Boundaries::Boundaries(const Graph& graph, ParticleStore& store)
    : graph_(graph), store_(store), next_id_(store.owned()) {
  for (const auto& plugin : graph.plugins())
    state_.emplace_back(static_cast<std::size_t>(std::max(0, plugin.table->state_size)), 0.0);
}

void Boundaries::connect(Evaluator& evaluator, Neighbourhood& neighbourhood) {
  evaluator_ = &evaluator;
  neighbourhood_ = &neighbourhood;
}

double Boundaries::inside() const {
  if (graph_.conserved() < 0) return 0;
  const double* amount = store_.data(graph_.name(graph_.conserved()));
  long double sum = 0;
  for (std::int64_t i = 0; i < store_.role_begin(1); ++i) sum += amount[i];
  return static_cast<double>(sum);
}

void Boundaries::begin(double time) {
  call(Call::begin, time, 0, nullptr);
  ledger_.initial = inside();
}

bool Boundaries::edit(double time, double dt) {
  return call(Call::edit, time, dt, nullptr);
}

void Boundaries::images(std::vector<Image>& images) {
  call(Call::images, 0, 0, &images);
}

bool Boundaries::call(Call which, double time, double dt, std::vector<Image>* images) {
  bool edited = false;
  roles_.resize(static_cast<std::size_t>(store_.owned()), RIFFLE_FLUID);
  if (store_.role_begin(1) != store_.owned() || roles_changed_) {
    for (int r = 0; r < role_count; ++r) {
      std::fill(roles_.begin() + store_.role_begin(r), roles_.begin() + store_.role_begin(r + 1), 1u << r);
    }
    roles_changed_ = false;
  }
  if (which == Call::images) neighbourhood_->reach(reach_);
  for (std::size_t p = 0; p < graph_.plugins().size(); ++p) {
    const ActivePlugin& plugin = graph_.plugins()[p];
    const auto function = which == Call::begin  ? plugin.table->begin
                          : which == Call::edit ? plugin.table->edit
                                                : plugin.table->images;
    if (function == nullptr) continue;
    Context context;
    context.store = &store_;
    context.evaluator = evaluator_;
    context.images = images;
    context.count = store_.owned();
    riffle_editor editor{};
    editor.size = sizeof editor;
    editor.dim = store_.dim();
    editor.count = context.count;
    editor.time = time;
    editor.dt = dt;
    editor.state = state_[p].data();
    editor.context = &context;
    editor.role = roles_.data();
    editor.reach = which == Call::images ? reach_.data() : nullptr;
    editor.read = [](void* c, const char* name, std::int32_t component) noexcept -> const double* {
      const Field* field = context_of<Context>(c).store->find(name);
      return field == nullptr ? nullptr : field->component[static_cast<std::size_t>(component)].data();
    };
    editor.write = [](void* c, const char* name, std::int32_t component) noexcept -> double* {
      auto& context = context_of<Context>(c);
      Field* field = context.store->find(name);
      if (field == nullptr) return nullptr;
      context.evaluator->changed(context.evaluator->graph().field(name));
      return field->component[static_cast<std::size_t>(component)].data();
    };
    editor.add = [](void* c, std::uint32_t role, std::int64_t like) noexcept -> std::int64_t {
      auto& context = context_of<Context>(c);
      const std::int64_t index = context.count + context.added;
      ++context.added;
      context.store->resize_images(context.added);  // the places of images serve as room; lists and images are void now
      for (const auto& [name, field] : context.store->fields()) {
        for (auto& array : field->component) array.data()[index] = array.data()[like];
      }
      context.like.push_back(like);
      context.retagged[index] = role;
      context.edited = true;
      return index;
    };
    editor.remove = [](void* c, std::int64_t index) noexcept {
      auto& context = context_of<Context>(c);
      context.removed.resize(std::max(context.removed.size(), static_cast<std::size_t>(index) + 1), 0);
      context.removed[static_cast<std::size_t>(index)] = 1;
      context.edited = true;
    };
    editor.retag = [](void* c, std::int64_t index, std::uint32_t role) noexcept {
      auto& context = context_of<Context>(c);
      context.retagged[index] = role;
      context.edited = true;
    };
    editor.image = [](void* c, std::int64_t origin, std::uint32_t how, std::int32_t axis,
                      const double* a) noexcept -> std::int64_t {
      auto& context = context_of<Context>(c);
      Image image{origin, how == RIFFLE_MIRROR, axis, {}};
      std::copy(a, a + context.store->dim(), image.a.begin());
      context.images->push_back(image);
      return context.count + static_cast<std::int64_t>(context.images->size()) - 1;
    };
    riffle_error error{sizeof(riffle_error), {}};
    if (function(plugin.self, &editor, &error) != RIFFLE_OK)
      throw RunError("boundary " + plugin.id + ": " + error.message);
    if (context.edited) {
      apply(context);
      edited = true;
    }
  }
  return edited;
}

// Groups what is left by role again, numbers the new ones, and writes the ledger: what becomes water came in, what was
// water and no longer is went out.
void Boundaries::apply(Context& context) {
  const auto before = [&](std::int64_t i) { return i < context.count ? roles_[static_cast<std::size_t>(i)] : 0u; };
  const auto total = static_cast<std::size_t>(context.count + context.added);
  context.removed.resize(total, 0);
  const double* amount = graph_.conserved() >= 0 ? store_.data(graph_.name(graph_.conserved())) : nullptr;
  std::vector<std::vector<std::int64_t>> by_role(role_count);
  for (std::size_t k = 0; k < total; ++k) {
    const auto i = static_cast<std::int64_t>(k);
    const auto tag = context.retagged.find(i);
    const std::uint32_t role = tag != context.retagged.end() ? tag->second : before(i);
    const bool was_water = before(i) == RIFFLE_FLUID;
    const bool is_water = context.removed[k] == 0 && role == RIFFLE_FLUID;
    if (amount != nullptr && is_water && !was_water) ledger_.in += amount[i];
    if (amount != nullptr && was_water && !is_water) ledger_.out += amount[i];
    if (context.removed[k] == 0) by_role[static_cast<std::size_t>(role_index(role))].push_back(i);
  }
  std::vector<std::int64_t> ids = store_.ids();
  for (std::int64_t a = 0; a < context.added; ++a) ids.push_back(next_id_++);
  std::vector<std::int64_t> order;
  std::array<std::int64_t, role_count> counts{};
  for (std::size_t r = 0; r < role_count; ++r) {
    counts[r] = static_cast<std::int64_t>(by_role[r].size());
    order.insert(order.end(), by_role[r].begin(), by_role[r].end());
  }
  store_.rearrange(order, counts, ids);
  roles_changed_ = true;
  evaluator_->everything_changed();
}

}  // namespace riffle
