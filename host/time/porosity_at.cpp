#include "host/time/porosity_at.hpp"

#include <stdexcept>
#include <string>

#include "host/plugins/call.hpp"

namespace riffle {

namespace {

bool makes_porosity_of_position(const riffle_pass& pass) {
  const auto named = [](const riffle_field* field, const char* name) { return std::string(field->name) == name; };
  return pass.type == RIFFLE_PASS_PARTICLE && (pass.flags & RIFFLE_INITIAL) == 0 && pass.reads != nullptr &&
         pass.reads[0] != nullptr && pass.reads[1] == nullptr && named(pass.reads[0]->field, "position") &&
         pass.writes != nullptr && pass.writes[0] != nullptr && pass.writes[1] == nullptr &&
         named(pass.writes[0]->field, "porosity");
}

}  // namespace

PorosityAt porosity_of(const PluginInstance* plugin) {
  if (plugin == nullptr || plugin->dim() != 2) return {};
  for (auto pass = plugin->table().passes; pass != nullptr && *pass != nullptr; ++pass) {
    if (!makes_porosity_of_position(**pass)) continue;
    return [plugin, pass = *pass](std::int64_t n, const double* x, const double* z, double* phi) {
      const double* const position[] = {x, z};
      const double* const* const in[] = {position};
      double* const porosity[] = {phi};
      double* const* const out[] = {porosity};
      const riffle_block block{sizeof(riffle_block), 2, n, 0, 0, 0, in, out};
      riffle_error error = no_error();
      const auto status = call_plugin(error, [&] { return may_throw(pass->run)(plugin->self(), &block, &error); });
      if (status != RIFFLE_OK) throw std::runtime_error(plugin->name() + ": " + message_of(error));
    };
  }
  return {};
}

}  // namespace riffle
