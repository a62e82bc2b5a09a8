#include "host/plugins/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/dll/shared_library.hpp>
#include <fstream>
#include <set>

#include "host/plugins/descriptor_checks.hpp"
#include "host/plugins/dictionary.hpp"
#include "host/plugins/elf.hpp"
#include "host/plugins/floating_point.hpp"
#include "host/plugins/sha256.hpp"

namespace riffle {
namespace {

constexpr const char* entry_name = "riffle_plugin_entry";

std::vector<std::byte> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size < 0) throw LibraryError({path.string() + ": cannot be read"});
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), size);
  if (!file) throw LibraryError({path.string() + ": cannot be read"});
  return bytes;
}

// The file exports an object of that name that is large enough for the version numbers.
void require_entry(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  try {
    for (const ExportedSymbol& symbol : exported_symbols(bytes)) {
      if (symbol.name == entry_name && symbol.size >= sizeof(riffle_library)) return;
    }
  } catch (const std::runtime_error& error) {
    throw LibraryError({fmt::format("{}: {}", path.string(), error.what())});
  }
  throw LibraryError({fmt::format("{}: is a shared library, but no plugin of Riffle: it does not export {}",
                                  path.string(), entry_name)});
}

// What the dynamic linker said, without Boost's words around it.
std::string linker_message(const std::string& text) {
  constexpr std::string_view before = "dlerror system message: ";
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return text;
  const std::size_t end = text.rfind("): ");
  return text.substr(begin + before.size(), end - begin - before.size());
}

const riffle_library& load(const std::filesystem::path& path) {
  // Never destroyed: an instance, a function pointer or a text of a plugin may outlive every object of ours.
  static auto* const handles = new std::vector<boost::dll::shared_library>;
  try {
    using boost::dll::load_mode::rtld_local;
    using boost::dll::load_mode::rtld_now;
    handles->emplace_back(path, rtld_now | rtld_local);
    return handles->back().get<const riffle_library>(entry_name);
  } catch (const std::exception& error) {
    throw LibraryError({fmt::format("{}: cannot be loaded: {}", path.string(), linker_message(error.what()))});
  } catch (...) {  // thrown by an initialiser of the library
    throw LibraryError({fmt::format("{}: cannot be loaded: it throws an exception of unknown type", path.string())});
  }
}

void require_version(const riffle_library& entry, const std::string& name) {
  if (entry.size < 4 * sizeof(std::uint32_t) || entry.size > sizeof(riffle_library)) {
    throw LibraryError({fmt::format("{}: riffle_library has size {}, but this program knows {}", name, entry.size,
                                    sizeof(riffle_library))});
  }
  if (entry.abi_major != RIFFLE_ABI_MAJOR) {
    throw LibraryError(
        {fmt::format("{}: speaks version {}.{} of the plugin boundary, this program {}.{}; another major "
                     "version is another language: rebuild it with this program's SDK",
                     name, entry.abi_major, entry.abi_minor, RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR)});
  }
  if (entry.abi_minor > RIFFLE_ABI_MINOR) {
    throw LibraryError(
        {fmt::format("{}: needs version {}.{} of the plugin boundary, this program speaks {}.{}; use a "
                     "newer Riffle, or rebuild it with this program's SDK",
                     name, entry.abi_major, entry.abi_minor, RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR)});
  }
  if (entry.real_bytes != sizeof(double)) {
    throw LibraryError({fmt::format("{}: works with numbers of {} bytes, this program with {}", name, entry.real_bytes,
                                    sizeof(double))});
  }
}

ParameterDescription describe_parameter(const riffle_parameter& p) {
  return {.name = p.name,
          .unit = p.unit,
          .doc = p.doc,
          .type = static_cast<ParameterType>(p.type),
          .required = (p.flags & RIFFLE_REQUIRED) != 0,
          .above_min = (p.flags & RIFFLE_ABOVE_MIN) != 0,
          .below_max = (p.flags & RIFFLE_BELOW_MAX) != 0,
          .path = (p.flags & RIFFLE_PATH) != 0,
          .choices = p.type == RIFFLE_CHOICE ? split_words(p.choices) : std::vector<std::string>{},
          .inherit = text_or_empty(p.inherit),
          .fallback = p.fallback,
          .min = p.min,
          .max = p.max,
          .fallback_text = text_or_empty(p.fallback_text)};
}

PluginDescription describe_plugin(const riffle_plugin& plugin) {
  PluginDescription d;
  d.id = plugin.id;
  d.kind = plugin.kind;
  d.version = plugin.version;
  d.summary = plugin.summary;
  d.source = text_or_empty(plugin.source);
  d.leaves_out = text_or_empty(plugin.leaves_out);
  for (const int dim : {1, 2, 3}) {
    if ((plugin.dims >> static_cast<unsigned>(dim) & 1U) != 0) d.dimensions.push_back(dim);
  }
  for (const riffle_parameter* p : Table(plugin.parameters)) d.parameters.push_back(describe_parameter(*p));
  for (const riffle_field* field : Table(plugin.initial)) d.initial.push_back(describe_field(*field));
  for (const riffle_field* field : Table(plugin.gives)) d.gives.push_back(describe_field(*field));
  if (plugin.requires_integrator != nullptr) d.integrators = split_words(plugin.requires_integrator);
  for (const riffle_refusal* r : Table(plugin.refuses)) d.refuses.push_back({r->kind, text_or_empty(r->id), r->reason});
  return d;
}

}  // namespace

LibraryError::LibraryError(std::vector<std::string> lines, std::vector<KindAndId> would_give)
    : std::runtime_error(fmt::format("{}", fmt::join(lines, "\n"))),
      lines_(std::move(lines)),
      would_give_(std::move(would_give)) {}

std::vector<Plugin> read_plugins(const riffle_library& entry, const std::string& name) {
  require_version(entry, name);
  std::vector<Plugin> plugins;
  std::vector<std::string> mistakes;
  std::set<LibraryError::KindAndId> names;
  for (const riffle_plugin* original : Table(entry.plugins)) {
    Problems problems(name);
    const CopiedPlugin copy = copy_descriptor(*original, entry.abi_minor, problems);
    if (copy.table != nullptr) {
      check_descriptor(*copy.table, name, problems);
      const auto kind_and_id = std::pair(text_or_empty(copy.table->kind), text_or_empty(copy.table->id));
      if (!names.insert(kind_and_id).second) problems.add("declared twice in this library");
    }
    mistakes.insert(mistakes.end(), problems.lines().begin(), problems.lines().end());
    if (problems.empty()) plugins.push_back({describe_plugin(*copy.table), copy.table, copy.owner});
  }
  if (names.empty() && mistakes.empty()) mistakes.push_back(name + ": holds no plugin");
  if (!mistakes.empty()) throw LibraryError(std::move(mistakes), {names.begin(), names.end()});
  for (Plugin& plugin : plugins) {
    plugin.description.library_path = name;
    plugin.description.build = text_or_empty(entry.build);
  }
  return plugins;
}

Library::Library(const std::filesystem::path& file) : path_(std::filesystem::absolute(file)) {
  const std::vector<std::byte> bytes = read_file(path_);
  require_entry(path_, bytes);
  FloatingPointGuard guard;
  const riffle_library& entry = load(path_);
  if (guard.restore()) {
    warnings_.push_back(
        fmt::format("{}: changes the floating-point arithmetic of the whole program when loaded, which "
                    "has been undone; it was probably built with -ffast-math, so its own results may "
                    "differ from what its source says",
                    path_.string()));
  }
  plugins_ = read_plugins(entry, path_.string());
  const std::string hash = sha256(bytes);
  for (Plugin& plugin : plugins_) plugin.description.library_hash = hash;
}

}  // namespace riffle
