#!/usr/bin/env python3
"""Front of a collapsing column beside measured ones: front.py RUN..., each a run of martin-moyce.toml with [output] profiles.

Z is the abscissa of the foremost particle over the width a of the column, T = t sqrt(2 g / a). Beside it the least and largest of the
three measured points nearest in T (dambreak_front_martinmoyce_koshizuka.csv), moved to that T along their mean path."""
import csv
import json
import math
import sys
from pathlib import Path

WIDTH, GRAVITY = 0.146, 9.81


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def measured(scaled):
    points = [(float(r["T"]), float(r["Z"])) for r in rows(Path(__file__).with_name("dambreak_front_martinmoyce_koshizuka.csv"))]
    nearest = sorted(points, key=lambda p: abs(p[0] - scaled))[:3]
    here = [z + 1.3 * (scaled - t) for t, z in nearest]  # fronts run at dZ/dT = 1.2 to 1.4 by then
    return min(here), max(here)


def main():
    for run in map(Path, sys.argv[1:]):
        manifest = json.loads((run / "run.json").read_text())["manifest"]
        step = manifest["output"]["profiles"]
        print(f"{run}\n| t [s] | T | Z | measured |\n|---|---|---|---|")
        for k, profile in enumerate(sorted((run / "profiles").glob("*.csv"))):
            t = (k + 1) * step
            front = max(float(row["x"]) for row in rows(profile)) / WIDTH
            scaled = t * math.sqrt(2 * GRAVITY / WIDTH)
            low, high = measured(scaled)
            print(f"| {t:.3g} | {scaled:.2f} | {front:.3f} | {low:.2f} to {high:.2f} |")


if __name__ == "__main__":
    main()
