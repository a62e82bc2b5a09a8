#include "host/time/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host/plugins/call.hpp"

namespace riffle {

// What the editor's functions work on during one call of one plugin.
struct Boundaries::Context {
  ParticleStore* store = nullptr;
  Evaluator* evaluator = nullptr;
  std::vector<Image>* images = nullptr;  // in `images` only
  std::set<int>* written = nullptr;
  std::string conserved;  // field of the ledger, or empty
  std::int64_t count = 0, added = 0;
  std::map<std::int64_t, std::uint32_t> retagged;  // and the roles of added particles
  std::vector<char> removed;
  std::vector<double> amounts;  // conserved, of owned particles, before the plugin was let at them
  bool edited = false;
  std::string mistake;  // the first thing the plugin asked for that makes no sense

  [[nodiscard]] bool is_particle(std::int64_t index) const { return index >= 0 && index < count + added; }
  // False, and the call is remembered as a mistake, when it must be ignored.
  bool expect(bool right, const std::string& rule) {
    if (!right && mistake.empty()) mistake = rule;
    return right;
  }
  bool may_edit(const char* call, std::int64_t index) {
    return expect(images == nullptr, std::string(call) + "() is for begin and edit, not for images") &&
           expect(is_particle(index), std::string(call) + "() names particle " + std::to_string(index) +
                                          ", but there are " + std::to_string(count + added));
  }
};

namespace {

template <class T>
T& context_of(void* p) {
  return *static_cast<T*>(p);
}

bool is_role(std::uint32_t bit) {
  return bit != 0 && (bit & (bit - 1)) == 0 && bit <= RIFFLE_ALL_ROLES;
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
  std::set<int> read;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const std::vector<int> fields = graph.particle_reads(static_cast<int>(n), true);
    read.insert(fields.begin(), fields.end());
  }
  for (const int f : read) {
    const GraphField& field = graph.fields()[static_cast<std::size_t>(f)];
    if (!field.evolved && !field.attribute && field.description.name != "smoothing_length") followed_.push_back(f);
  }
}

// What passes make of the water and read of neighbours (factors, gradients) nobody makes of buffers in one dimension:
// they take it from the water next to them, unless their boundary says otherwise.
void Boundaries::follow_water() {
  const std::int64_t water = store_.role_begin(1);
  if (store_.dim() != 1 || water == 0 || !has_buffers()) return;
  const double* x = store_.data("position");
  const double middle = 0.5 * (x[0] + x[water - 1]);
  for (const int f : followed_) {
    Field* field = store_.find(graph_.name(f));
    if (field == nullptr || written_.count(f) != 0) continue;
    for (auto& component : field->component) {
      double* values = component.data();
      for (std::int64_t i = store_.role_begin(2); i < store_.role_begin(4); ++i)
        values[i] = x[i] < middle ? values[0] : values[water - 1];
    }
    evaluator_->changed(f);
  }
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

bool Boundaries::exchanges() const {
  return graph_.conserved() >= 0 && graph_.fields()[static_cast<std::size_t>(graph_.conserved())].evolved &&
         store_.owned() > store_.role_begin(1);
}

void Boundaries::enter_exchange(double before) {
  if (!exchanges()) return;
  const double change = inside() - before;
  if (change > 0)
    ledger_.enter(change);
  else
    ledger_.leave(-change);
}

void Boundaries::begin(double time) {
  call(Call::begin, time, 0, nullptr);
  if (has_buffers()) {  // which need what the passes make of the water, before the first step
    std::vector<int> rates;
    for (const auto& e : graph_.evolved()) rates.push_back(e.rate);
    evaluator_->compute(rates, time, 0);
    follow_water();
    evaluator_->everything_changed();
  }
  ledger_ = Ledger{};
  ledger_.initial = inside();
}

bool Boundaries::edit(double time, double dt) {
  const bool edited = call(Call::edit, time, dt, nullptr);
  follow_water();
  return edited;
}

void Boundaries::images(std::vector<Image>& images) {
  call(Call::images, 0, 0, &images);
}

bool Boundaries::call(Call which, double time, double dt, std::vector<Image>* images) {
  bool edited = false;
  for (std::size_t p = 0; p < graph_.plugins().size(); ++p) {
    const ActivePlugin& plugin = graph_.plugins()[p];
    const auto function = which == Call::begin  ? plugin.table->begin
                          : which == Call::edit ? plugin.table->edit
                                                : plugin.table->images;
    if (function == nullptr) continue;
    update_roles();
    Context context;
    context.store = &store_;
    context.evaluator = evaluator_;
    context.images = images;
    context.written = &written_;
    context.count = store_.owned();
    if (graph_.conserved() >= 0) context.conserved = graph_.name(graph_.conserved());
    riffle_editor editor{};
    editor.size = sizeof editor;
    editor.dim = store_.dim();
    editor.count = context.count;
    editor.time = time;
    editor.dt = dt;
    editor.state = state_[p].data();
    editor.context = &context;
    editor.role = roles_.data();
    if (store_.find("smoothing_length") != nullptr) neighbourhood_->reach(reach_);
    editor.reach = reach_.data();
    editor.read = [](void* c, const char* name, std::int32_t component) noexcept -> const double* {
      const Field* field = context_of<Context>(c).store->find(name);
      if (field == nullptr || component < 0 || static_cast<std::size_t>(component) >= field->component.size())
        return nullptr;
      return field->component[static_cast<std::size_t>(component)].data();
    };
    editor.write = [](void* c, const char* name, std::int32_t component) noexcept -> double* {
      auto& context = context_of<Context>(c);
      Field* field = context.store->find(name);
      if (field == nullptr || component < 0 || static_cast<std::size_t>(component) >= field->component.size())
        return nullptr;
      if (context.conserved == name && context.amounts.empty()) {
        const double* amount = field->component[0].data();
        context.amounts.assign(amount, amount + context.count);
      }
      const int index = context.evaluator->graph().field(name);
      context.written->insert(index);
      context.evaluator->changed(index);
      return field->component[static_cast<std::size_t>(component)].data();
    };
    editor.add = [](void* c, std::uint32_t role, std::int64_t like) noexcept -> std::int64_t {
      auto& context = context_of<Context>(c);
      if (!context.may_edit("add", like) || !context.expect(is_role(role), "add() wants one role")) return like;
      const std::int64_t index = context.count + context.added;
      ++context.added;
      context.store->resize_images(context.added);  // the places of images serve as room; lists and images are void now
      for (const auto& [name, field] : context.store->fields()) {
        for (auto& array : field->component) array.data()[index] = array.data()[like];
      }
      context.retagged[index] = role;
      context.edited = true;
      return index;
    };
    editor.remove = [](void* c, std::int64_t index) noexcept {
      auto& context = context_of<Context>(c);
      if (!context.may_edit("remove", index)) return;
      context.removed.resize(std::max(context.removed.size(), static_cast<std::size_t>(index) + 1), 0);
      context.removed[static_cast<std::size_t>(index)] = 1;
      context.edited = true;
    };
    editor.retag = [](void* c, std::int64_t index, std::uint32_t role) noexcept {
      auto& context = context_of<Context>(c);
      if (!context.may_edit("retag", index) || !context.expect(is_role(role), "retag() wants one role")) return;
      context.retagged[index] = role;
      context.edited = true;
    };
    editor.image = [](void* c, std::int64_t origin, std::uint32_t how, std::int32_t axis,
                      const double* a) noexcept -> std::int64_t {
      auto& context = context_of<Context>(c);
      if (!context.expect(context.images != nullptr, "image() is for images, not for begin and edit")) return origin;
      const auto known = context.count + static_cast<std::int64_t>(context.images->size());
      if (!context.expect(origin >= 0 && origin < known,
                          "image() of " + std::to_string(origin) + ", which is no particle and no image before it") ||
          !context.expect(how == RIFFLE_SHIFT || (how == RIFFLE_MIRROR && axis >= 0 && axis < context.store->dim()),
                          "image() wants a mirror normal to an axis that exists, or a shift"))
        return origin;
      Image image{origin, how == RIFFLE_MIRROR, axis, {}};
      std::copy(a, a + context.store->dim(), image.a.begin());
      context.images->push_back(image);
      return context.count + static_cast<std::int64_t>(context.images->size()) - 1;
    };
    riffle_error error{sizeof(riffle_error), {}};
    if (call_plugin(error, [&] { return may_throw(function)(plugin.self, &editor, &error); }) != RIFFLE_OK)
      throw RunError("boundary " + plugin.id + ": " + message_of(error));
    if (!context.mistake.empty()) throw RunError("boundary " + plugin.id + ": " + context.mistake);
    enter_changes(context);
    if (context.edited) {
      apply(context);
      edited = true;
    }
  }
  return edited;
}

void Boundaries::update_roles() {
  if (!roles_changed_ && roles_.size() == static_cast<std::size_t>(store_.owned())) return;
  roles_.resize(static_cast<std::size_t>(store_.owned()));
  for (int r = 0; r < role_count; ++r) {
    std::fill(roles_.begin() + store_.role_begin(r), roles_.begin() + store_.role_begin(r + 1), 1u << r);
  }
  roles_changed_ = false;
}

// What the plugin wrote into the conserved field of water that was there before.
void Boundaries::enter_changes(const Context& context) {
  if (context.amounts.empty()) return;
  const double* amount = store_.data(context.conserved);
  for (std::size_t i = 0; i < context.amounts.size(); ++i) {
    if (roles_[i] != RIFFLE_FLUID) continue;
    const double change = amount[i] - context.amounts[i];
    if (change > 0)
      ledger_.enter(change);
    else
      ledger_.leave(-change);
  }
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
    if (amount != nullptr && is_water && !was_water) ledger_.enter(amount[i]);
    if (amount != nullptr && was_water && !is_water) ledger_.leave(amount[i]);
    if (context.removed[k] == 0) by_role[static_cast<std::size_t>(role_index(role))].push_back(i);
  }
  std::vector<std::int64_t> ids = store_.ids();
  for (std::int64_t a = 0; a < context.added; ++a) ids.push_back(next_id_++);
  if (store_.dim() == 1) {  // they stand in order of x but for those that just came
    const double* x = store_.data("position");
    for (auto& list : by_role) {
      const auto before = [x](std::int64_t a, std::int64_t b) { return x[a] < x[b]; };
      if (!std::is_sorted(list.begin(), list.end(), before)) std::stable_sort(list.begin(), list.end(), before);
    }
  }
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
