#!/usr/bin/env python3
"""Uniformity and balance of momentum in the measuring zone of a flume between open ends: means over time, from profiles.

  zone.py RUN [FROM [x1 x2]]      FROM in s (half of the run); x1, x2 in m (4.5 and 6.5 inlet depths)

The run needs [output] profiles and fields velocity, pressure, porosity, mass, density and drag_rate. Per third of the zone: depth
(volume of water and grains per length), discharge, mean velocity above the crest. Over the zone: drag over weight along the
bed, and what pressure and momentum bring in through its ends, over the same; the wall takes 0.1 %.
"""

import csv
import json
import pathlib
import sys


def rows_of(path):
    time, lines = None, []
    with open(path, encoding="utf-8") as text:
        for line in text:
            if line.startswith("# time:"):
                time = float(line.split()[2])
            elif not line.startswith("#"):
                lines.append(line)
    return time, csv.DictReader(lines)


def main():
    folder = pathlib.Path(sys.argv[1])
    record = json.loads((folder / "run.json").read_text(encoding="utf-8")) if (folder / "run.json").exists() else None
    paths = sorted((folder / "profiles").glob("*.csv"))
    begin = float(sys.argv[2]) if len(sys.argv) > 2 else rows_of(paths[-1])[0] / 2
    x1, x2 = (float(sys.argv[3]), float(sys.argv[4])) if len(sys.argv) > 4 else (1.22, 1.76)
    crest, force = 0.0876, 9.81 * 0.0026
    if record:
        plugins = record["manifest"]["plugins"]
        crest, force = plugins["porosity"]["crest"], 9.81 * plugins["equations"]["bed_slope"]
    samples, thirds, weight, drag = 0, [[0.0] * 4 for _ in range(3)], 0.0, 0.0
    half, ends = 0.1, [0.0, 0.0]
    for path in paths:
        time, rows = rows_of(path)
        if time < begin:
            continue
        samples += 1
        for row in rows:
            x, z, u = float(row["x"]), float(row["z"]), float(row["velocity_x"])
            m, rho, phi = float(row["mass"]), float(row["density"]), float(row["porosity"])
            for k, end in enumerate((x1, x2)):
                off = abs(x - end) / half
                if off < 1:
                    ends[k] += (1 - off) / half * m / rho * (float(row["pressure"]) + rho * u * u)
            if not x1 <= x < x2:
                continue
            weight += m * force
            drag += m * float(row["drag_rate"]) * u
            third = thirds[int(3 * (x - x1) / (x2 - x1))]
            third[0] += m / rho / phi
            third[1] += m / rho * u
            if z > crest:
                third[2] += m / rho
                third[3] += m / rho * u
    length = (x2 - x1) / 3 * samples
    print(f"{samples} samples from {begin:g} s")
    for k, (volume, carried, above, fast) in enumerate(thirds):
        print(f"  third {k + 1}: depth {1000 * volume / length:.2f} mm, q {carried / length:.5f} m2/s, "
              f"U above the crest {fast / above:.4f} m/s")
    print(f"  drag over weight {drag / weight:.4f}; through the ends {(ends[0] - ends[1]) / weight:+.4f} of it")
    if record:
        for plugin in record["plugins"]:
            if plugin["state"] and plugin["id"] == "outflow-imaginary-wall":
                print(f"  height of the wall {plugin['state'][0]:.4f} m")


if __name__ == "__main__":
    main()
