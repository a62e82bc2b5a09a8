#!/usr/bin/env python3
"""Uniformity and balance of momentum in the measuring zone of a flume between open ends: means over time, from profiles.

  zone.py RUN [FROM [x1 x2]]      FROM in s (half of the run); x1, x2 in m (4.5 and 6.5 inlet depths)

The run needs [output] profiles and fields velocity, pressure, porosity, mass, density and drag_rate. Per third of the zone: depth
(volume of water and grains per length), discharge, mean velocity above the crest. Over the zone: drag over weight along the bed;
what the fall of the surface adds to the weight, by the pressure of the water above the crest; and the momentum that comes in
less that which goes out. Drag = 1 + both, less the 0.1 % of the wall.
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
    half, head, flux = 0.1, [[0.0, 0.0], [0.0, 0.0]], [0.0, 0.0]
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
                    flux[k] += (1 - off) / half * m * u * u
                    if z > crest:
                        head[k][0] += 1 - off
                        head[k][1] += (1 - off) * (z + float(row["pressure"]) / 9810)
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
    fall = (head[0][1] / head[0][0] - head[1][1] / head[1][0]) / (x2 - x1) * 9.81 / force
    print(f"  drag over weight {drag / weight:.4f}; fall of the surface {fall:+.4f}, momentum {(flux[0] - flux[1]) / weight:+.4f} of it")
    if record:
        for plugin in record["plugins"]:
            if plugin["state"] and plugin["id"] == "outflow-imaginary-wall":
                print(f"  height of the wall {plugin['state'][0]:.4f} m")


if __name__ == "__main__":
    main()
