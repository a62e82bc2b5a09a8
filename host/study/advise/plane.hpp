// The rules for scenes that resolve the depth (two and three dimensions), whatever plugins they name: what is measured on their
// particles at t = 0 and in their first steps says which terms carry the flow, and whether a column of water tells all.
#pragma once

#include "host/study/advise/advice.hpp"
#include "host/study/advise/model_notes.hpp"

namespace riffle {

// Adds figures, terms and the proposal. Throws std::runtime_error when the case cannot be started.
void advise_on_plane(const AdviceRequest& request, const Case& scene, const Registry& registry,
                     const std::vector<ModelNotes>& models, Advice& advice);

}  // namespace riffle
