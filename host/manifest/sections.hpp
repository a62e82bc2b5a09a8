// The parts of a manifest that need the catalogue of plugins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/manifest/reading.hpp"

namespace riffle {

// [plugins.*]: fills result.plugins; checks that there is one equations plugin and one kernel, and the integrator.
void read_plugins(Reading& reading);

// [initial.particles] and `inside`, which need no plugin.
void read_particles(Reading& reading);

// The initial fields. After read_plugins and read_particles.
void read_initial_fields(Reading& reading);

// [reference].
void read_reference(Reading& reading);

// [surface].
void read_surface(Reading& reading);

// One plugin: id, parameters and defaults, from the table [`shown`]. Keys in `besides` are left to the caller. The kind
// is known. Nothing when the plugin is not.
std::optional<PluginChoice> read_plugin(Reading& reading, const TomlNode& table, const std::string& shown,
                                        const std::string& kind, const std::vector<std::string>& besides,
                                        nlohmann::ordered_json& effective);

// The plugins of a kind, by name.
std::vector<std::string> ids_of(const PluginCatalogue& catalogue, const std::string& kind);

// The equation set of the case; nullptr when there is none (which is a mistake already noted).
const PluginDescription* equation_set(const Reading& reading);

}  // namespace riffle
