// How much vertical acceleration changes a depth-averaged flow, from a hydrostatic run of it.
//
// Behind a bore that does not break waves grow (an undular bore), in front of and behind any other front the water is only
// rounded over a length that grows with the third root of time (Airy). With strength d = (h2 - h1) / h1 and c1 = sqrt(g h1),
// the integral of the change of depth is about
//
//   undular:  h1 c1 t d^2 / (1 + d) + 1.3 (h2 - h1) (h1^2 c1 t / 2)^(1/3)       first term: width 5/2 d c1 t of the train of
//   broken:   (h2 - h1) min(1.8 (h1^2 c1 t / 2)^(1/3), 3.6 h2)                Korteweg & de Vries times its mean height 2/5 d h1
//   standing: (h2 - h1) 3/2 h2                                                a roller six depths long (Chow 1959, fig. 15-4)
//   the start of a jump of the level:  0.3 H (H - h2)                         collapse of the part that makes no bore
//
// of which the numbers 1.3, 1.8 and 0.3 were fitted to runs of serre against shallow water at depth ratios 0.1 to 0.7
// (docs/advising.md shows how well). Where there is no front, waves of relative pressure R run late by R h / (4 |elevation|)
// of their way (from the phase speed 1 - (k h)^2 / 6), and steady flow has its depth changed by R h / 2 over |1 - Fr^2|.
#pragma once

#include "host/study/advise/flow.hpp"
#include "host/study/advise/scout.hpp"

namespace riffle {

struct DispersionEstimate {
  double fronts = 0, smooth = 0;  // contributions to the depth, shares of it
  double largest_ratio =
      0;  // of non-hydrostatic to hydrostatic pressure outside of fronts; 995 of 1000 points are below
  double strongest_front = 0;  // (h2 - h1) / h1
  bool breaks = false;         // a bore breaks
  [[nodiscard]] double total() const { return fronts + smooth; }
};

// `steady`: the state does not change any more at the end.
DispersionEstimate estimate_dispersion(const Scout& scout, double gravity, bool steady);

}  // namespace riffle
