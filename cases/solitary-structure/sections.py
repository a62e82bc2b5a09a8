#!/usr/bin/env python3
"""Velocities over and behind the structure of wu-hsiao.toml at the sections and times of Kazemi (2017), figs 5-16 to 5-25.

  sections.py RUN                   writes RUN/sections.csv: t, x, z, u, w; and the largest velocities of each
  sections.py RUN POINTS.csv        the same, and root mean squares of the differences from measured points with the columns
                                    t, x, z, u, w (s, m, m/s), beside those of tables 5-3 and 5-4 of the thesis

x from the front of the structure, z from the bottom; t = 0 when the crest passes the gauge at x = -1.8 m. Velocities are means
of the particles within 1.5 spacings, and between two profiles linear in time. The run must write velocity, mass and density,
and profiles at least every 0.1 s."""

import csv
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from wave import crest_of, rows_of  # noqa: E402

FRONT, GAUGE, DEPTH = 4.0, 2.2, 0.106  # m: x of the structure and of the gauge, still water
SECTIONS, TIMES = (-0.04, 0.0, 0.04, 0.08, 0.12, 0.16), (1.45, 1.65, 1.85, 2.05, 2.25)
THESIS = {"u": ((0.0382, 0.0921, 0.087, 0.0536, 0.088, 0.0208), (0.0353, 0.0515, 0.0579, 0.0918, 0.105, 0.1035),
                (0.0305, 0.0299, 0.0434, 0.0631, 0.0549, 0.1578), (0.036, 0.0291, 0.0308, 0.0268, 0.0209, 0.1802),
                (0.0182, 0.0247, 0.02, 0.044, 0.027, 0.1737)),
          "w": ((0.0504, 0.0663, 0.0639, 0.0356, 0.0155, 0.0319), (0.0207, 0.043, 0.0221, 0.0402, 0.029, 0.0812),
                (0.0116, 0.018, 0.0168, 0.0262, 0.0324, 0.1289), (0.0105, 0.0158, 0.0231, 0.0201, 0.0207, 0.0437),
                (0.0106, 0.0228, 0.0074, 0.0115, 0.0503, 0.0669))}


class Run:
    def __init__(self, folder):
        record = json.loads((folder / "run.json").read_text())
        self.reach = 1.5 * record["manifest"]["initial"]["particles"]["spacing"]
        self.states, gauge = [], []
        for path in sorted((folder / "profiles").glob("*.csv")) + [folder / "profile.csv"]:
            time, rows = rows_of(path)
            x, level = crest_of([(float(r["x"]), float(r["mass"]) / float(r["density"])) for r in rows
                                 if float(r["x"]) < FRONT - 0.3])
            gauge.append((time, x, level))
            near = [tuple(float(r[k]) for k in ("x", "z", "velocity_x", "velocity_z")) for r in rows
                    if FRONT - 0.3 < float(r["x"]) < FRONT + 0.6]
            self.states.append((time, near))
        self.zero = next(ta + (tb - ta) * (GAUGE - xa) / (xb - xa) for (ta, xa, _), (tb, xb, h) in zip(gauge, gauge[1:])
                         if xa < GAUGE <= xb and h > 1.1 * DEPTH)

    def velocity(self, t, x, z):
        """u, w [m/s] at a time after zero, or None where there is no water."""
        at, found = t + self.zero, []
        for time, water in self.states:
            if abs(time - at) > 0.11:
                continue
            sums = [0.0, 0.0, 0.0]
            for px, pz, u, w in water:
                r2 = ((px - FRONT - x)**2 + (pz - z)**2) / self.reach**2
                if r2 < 1:
                    weight = (1 - r2)**2
                    sums = [sums[0] + weight, sums[1] + weight * u, sums[2] + weight * w]
            found.append((time, sums[1] / sums[0], sums[2] / sums[0]) if sums[0] > 0.3 else (time, None, None))
        before = [f for f in found if f[0] <= at][-1:]
        after = [f for f in found if f[0] >= at][:1]
        if not before or not after or before[0][1] is None or after[0][1] is None:
            return None
        (ta, ua, wa), (tb, ub, wb) = before[0], after[0]
        part = (at - ta) / (tb - ta) if tb > ta else 0
        return ua + part * (ub - ua), wa + part * (wb - wa)


def main(folder, points=None):
    run = Run(pathlib.Path(folder))
    print(f"the crest passes the gauge at {run.zero:.3f} s")
    with open(pathlib.Path(folder) / "sections.csv", "w", encoding="utf-8") as out:
        out.write("t,x,z,u,w\n")
        for t in TIMES:
            line = []
            for x in SECTIONS:
                profile = [(z, run.velocity(t, x, z)) for z in (0.0025 * k for k in range(1, 64))]
                for z, v in profile:
                    if v:
                        out.write(f"{t},{x},{z:.4f},{v[0]:.4f},{v[1]:.4f}\n")
                line.append(max((v[0] for _, v in profile if v), key=abs))
            print(f"t = {t} s, largest u at x = {SECTIONS}: " + " ".join(f"{u:+.3f}" for u in line))
    if points is None:
        return
    with open(points, encoding="utf-8") as lines:
        measured = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(r for r in lines if r[0] != "#")]
    for i, t in enumerate(TIMES):
        for k, x in enumerate(SECTIONS):
            pairs = [(p, run.velocity(t, x, p["z"])) for p in measured
                     if abs(p["t"] - t) < 1e-6 and abs(p["x"] - x) < 1e-6]
            pairs = [(p, v) for p, v in pairs if v]
            if not pairs:
                continue
            for c, name in enumerate("uw"):
                rmse = math.sqrt(sum((v[c] - p[name])**2 for p, v in pairs) / len(pairs))
                print(f"t = {t} s, x = {x} m, {name}: RMSE {rmse:.4f} m/s ({len(pairs)} points; thesis {THESIS[name][i][k]})")


if __name__ == "__main__":
    main(*sys.argv[1:3])
