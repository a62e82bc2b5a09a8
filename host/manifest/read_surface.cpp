#include <fmt/format.h>

#include "host/manifest/csv_table.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/tables.hpp"

namespace riffle {

void read_surface(Reading& reading) {
  const TomlNode* const table = find_table(reading, "surface");
  if (table == nullptr) {
    reading.effective.erase("surface");
    return;
  }
  const OwnTable own = read_own_table(reading, table, "surface");
  if (reading.dim != 0 && reading.dim != 2)
    reading.mistakes.add(table->place,
                         fmt::format("[surface] is for domain.dimension = 2, the vertical plane, got {}", reading.dim));
  if (!own.has("csv")) return;
  const SourcePlace place = table->find("csv")->value.place;
  SurfaceControl surface;
  try {
    const std::filesystem::path file = own.text("csv");
    const CsvTable csv(file, file.filename().string());
    bool whole = true;
    for (const std::string key : {"time", "x", "level"}) {
      if (csv.has(own.text(key))) continue;
      reading.mistakes.add(
          place, fmt::format("surface.{}: {} has no column \"{}\"", key, file.filename().string(), own.text(key)));
      whole = false;
    }
    if (!whole) return;
    const auto t = csv.numbers(own.text("time")), x = csv.numbers(own.text("x")), z = csv.numbers(own.text("level"));
    for (std::size_t k = 0; k < t.size(); ++k) surface.points[t[k]].push_back({x[k], z[k]});
  } catch (const TableError& error) {
    reading.mistakes.add(place, fmt::format("surface.csv: {}", error.what()));
    return;
  }
  reading.result.surface = std::move(surface);
}

}  // namespace riffle
