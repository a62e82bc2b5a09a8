#include <cmath>
#include <cstdlib>
#include <limits>

#include "host/manifest/read.hpp"
#include "host/study/advise/advice.hpp"
#include "host/study/advise/channel.hpp"
#include "host/study/advise/model_notes.hpp"
#include "host/study/advise/plane.hpp"

namespace riffle {

double number_in(const Overrides& changes, const std::string& key, double otherwise) {
  for (const std::string& change : changes) {
    if (change.rfind(key + '=', 0) == 0) otherwise = std::atof(change.c_str() + key.size() + 1);
  }
  return otherwise;
}

double Term::measured() const {
  return trial && trial->done ? trial->difference : std::numeric_limits<double>::quiet_NaN();
}

double Term::best() const {
  return trial && trial->done && !trial->against_reference ? trial->difference : contributes;
}

Advice advise(const AdviceRequest& request, const Registry& registry) {
  const Case scene = read_case(request.manifest, request.overrides, registry);
  const std::vector<ModelNotes> models = known_models(registry);
  Advice advice;
  advice.case_name = scene.name;
  advice.title = scene.title;
  advice.tolerance = request.tolerance;
  if (scene.dimension == 1) {
    advise_on_channel(request, scene, registry, models, advice);
  } else {
    advise_on_plane(request, scene, registry, models, advice);
  }
  return advice;
}

}  // namespace riffle
