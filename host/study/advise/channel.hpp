// The rules for flow along a channel (one dimension, with a depth): what a scout and its variants say about each term.
#pragma once

#include "host/study/advise/advice.hpp"
#include "host/study/advise/model_notes.hpp"

namespace riffle {

// Adds figures, terms and the proposal. Throws std::runtime_error when no model can run the case.
void advise_on_channel(const AdviceRequest& request, const Case& scene, const Registry& registry,
                       const std::vector<ModelNotes>& models, Advice& advice);

}  // namespace riffle
