#!/usr/bin/env python3
"""Level of the water at the toe of a breakwater and velocity along its slope, of a run of this folder, over time.

  gauges.py RUN [ABOVE]             writes RUN/gauges.csv: t, level, u (s, m above still water, m/s); ABOVE the slope in m,
                                    0.057 if not given (0.019 for the smooth one); prints crest, trough and largest velocities
  gauges.py RUN ABOVE POINTS.csv    the same, and root mean squares of the differences from measured points with the columns
                                    t, level, u (any of the last two), beside those of table 5-5 of Kazemi (2017)

t = 0 when the crest passes the toe. The level is a sum of volumes about the toe as wide as a Gaussian of 1 cm; the velocity is
the mean over 1.5 spacings, at section I, here 0.2 m along the slope from the toe: the thesis has the place in a figure only.
The run must write velocity, mass, density and porosity, and profiles at least every 0.1 s."""

import csv
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "solitary-structure"))
from wave import WIDTH, rows_of  # noqa: E402

TOE, DEPTH, SLOPE, ALONG = 5.0, 0.4, 1 / 1.5, 0.2  # m: x of the toe, still water; rise over run; section I
THESIS = {"smooth": (0.0142, 0.063), "rough": (0.0161, 0.1059), "porous": (0.0145, 0.0889)}


def series_of(folder, above):
    record = json.loads((folder / "run.json").read_text())
    reach = 1.5 * record["manifest"]["initial"]["particles"]["spacing"]
    cos = 1 / math.hypot(1, SLOPE)
    at = (TOE + cos * ALONG - above * SLOPE * cos, SLOPE * cos * ALONG + above * cos)
    series = []
    for path in sorted((folder / "profiles").glob("*.csv")) + [folder / "profile.csv"]:
        time, rows = rows_of(path)
        level, weight, along = 0.0, 0.0, 0.0
        for r in rows:
            x, z = float(r["x"]), float(r["z"])
            if abs(x - TOE) < 5 * WIDTH:
                volume = float(r["mass"]) / float(r["density"]) / float(r.get("porosity", 1))
                level += volume * math.exp(-0.5 * ((x - TOE) / WIDTH)**2) / (WIDTH * math.sqrt(2 * math.pi))
            r2 = ((x - at[0])**2 + (z - at[1])**2) / reach**2
            if r2 < 1:
                w = (1 - r2)**2
                weight, along = weight + w, along + w * (float(r["velocity_x"]) + SLOPE * float(r["velocity_z"])) * cos
        series.append((time, level - DEPTH, along / weight if weight > 0.3 else math.nan))
    zero = max(series, key=lambda s: s[1])[0]
    return [(t - zero, level, u) for t, level, u in series]


def main(folder, above=0.057, points=None):
    folder = pathlib.Path(folder)
    series = series_of(folder, float(above))
    with open(folder / "gauges.csv", "w", encoding="utf-8") as out:
        out.write("t,level,u\n" + "".join(f"{t:.4f},{level:.5f},{u:.4f}\n" for t, level, u in series))
    wet = [s for s in series if s[2] == s[2]]
    for name, of in (("crest at the toe", max(series, key=lambda s: s[1])), ("trough", min(series, key=lambda s: s[1])),
                     ("fastest up the slope", max(wet, key=lambda s: s[2])), ("fastest down", min(wet, key=lambda s: s[2]))):
        print(f"{name}: t = {of[0]:+.2f} s, level {1e3 * of[1]:+.1f} mm, u {of[2]:+.3f} m/s")
    if points is None:
        return
    with open(points, encoding="utf-8") as lines:
        measured = list(csv.DictReader(r for r in lines if r[0] != "#"))
    kind = json.loads((folder / "run.json").read_text())["case"].removeprefix("breakwater-")
    for c, name, unit in ((1, "level", "m"), (2, "u", "m/s")):
        squares = []
        for p in (p for p in measured if p.get(name)):
            for a, b in zip(series, series[1:]):
                if a[0] <= float(p["t"]) < b[0]:
                    value = a[c] + (b[c] - a[c]) * (float(p["t"]) - a[0]) / (b[0] - a[0])
                    squares += [(value - float(p[name]))**2] if value == value else []
        if squares:
            print(f"{name}: RMSE {math.sqrt(sum(squares) / len(squares)):.4f} {unit} ({len(squares)} points; "
                  f"thesis {THESIS.get(kind, (None, None))[c - 1]})")


if __name__ == "__main__":
    main(*sys.argv[1:4])
