#!/usr/bin/env python3
"""Height and speed of a solitary wave along a flume, from the profiles of a run.

  wave.py RUN [DEPTH]           heights at x = 1 to 4 m, and the speed between 1.5 and 3.8 m beside Fenton's at that height

The level at x is the sum of volumes m/rho times a Gaussian of 1 cm about x, the crest the highest of it through a parabola.
Fenton (1972) to third order: c^2 = g h0 (1 + e - e^2/20 - 3 e^3/70), e = H/h0. The run must write mass and density."""

import csv
import math
import pathlib
import sys

WIDTH = 0.01  # m, of the Gaussian


def rows_of(path):
    with open(path, encoding="utf-8") as lines:
        text = [line for line in lines]
    time = next(float(line.split()[2]) for line in text if line.startswith("# time:"))
    return time, list(csv.DictReader(line for line in text if not line.startswith("#")))


def crest_of(water):
    """Abscissa and level of the crest [m]."""
    step, columns = WIDTH / 2, {}
    for x, volume in water:
        columns.setdefault(round(x / step), []).append((x, volume))

    def level(k):
        return sum(v * math.exp(-0.5 * ((x - k * step) / WIDTH)**2) for m in range(k - 9, k + 10)
                   for x, v in columns.get(m, ())) / (WIDTH * math.sqrt(2 * math.pi))

    inside = range(min(columns) + 9, max(columns) - 8)
    levels = {k: level(k) for k in inside}
    top = max(list(inside)[1:-1], key=levels.get)
    a, b, c = levels[top - 1], levels[top], levels[top + 1]
    shift = 0.5 * (a - c) / (a - 2 * b + c)
    return (top + shift) * step, b - 0.25 * (a - c) * shift


def main(run, depth=0.106):
    run = pathlib.Path(run)
    crests = []
    for path in sorted((run / "profiles").glob("*.csv")) + [run / "profile.csv"]:
        time, rows = rows_of(path)
        x, level = crest_of([(float(r["x"]), float(r["mass"]) / float(r["density"])) for r in rows])
        crests.append((time, x, level - depth))
    for at in (1, 1.5, 2, 2.5, 3, 3.5, 4):
        for (_, xa, ha), (_, xb, hb) in zip(crests, crests[1:]):
            if xa < at <= xb and ha > 0.1 * depth:
                print(f"x = {at:3} m: height {1e3 * (ha + (hb - ha) * (at - xa) / (xb - xa)):.2f} mm")
    way = [(t, x, h) for t, x, h in crests if 1.5 <= x <= 3.8 and h > 0.1 * depth]
    n, t0, x0 = len(way), sum(t for t, _, _ in way) / len(way), sum(x for _, x, _ in way) / len(way)
    speed = sum((t - t0) * (x - x0) for t, x, _ in way) / sum((t - t0)**2 for t, _, _ in way)
    e = sum(h for _, _, h in way) / n / depth
    fenton = math.sqrt(9.81 * depth * (1 + e - e * e / 20 - 3 * e**3 / 70))
    print(f"speed {speed:.4f} m/s; Fenton at the mean height of {1e3 * e * depth:.2f} mm {fenton:.4f} m/s: "
          f"{100 * (speed / fenton - 1):+.2f} %")


if __name__ == "__main__":
    main(sys.argv[1], *(float(a) for a in sys.argv[2:3]))
