#!/usr/bin/env python3
"""Means over time of runs in this folder, beside the column model: a row per run, and means.csv in its folder.

  profiles.py RUN...          from 5 s on, in rows of one particle spacing

Columns: U of the particles and of the column at the same places; their largest difference in u(z) over U; the largest
difference in the modelled shear stress above the crest, and more than a support above it, over rho g S0 H; the largest virial
stress over the same; the rise of the surface since t = 0 over H; the largest mean velocity across the bed over U.
"""

import csv
import json
import pathlib
import sys

FIELDS = ("velocity_x", "velocity_x_exact", "velocity_z", "modelled_shear_stress", "modelled_shear_stress_exact",
          "virial_shear_stress")


def rows_of(path):
    with open(path, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def time_of(path):
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            if line.startswith("# time:"):
                return float(line.split()[2])
    raise ValueError(f"{path} does not say its time")


def means_of(paths, spacing):
    """Means of z and FIELDS of the particles that lie in a row, per row, with their number; from the bed up."""
    rows = {}
    for path in paths:
        for particle in rows_of(path):
            z = float(particle["z"])
            row = rows.setdefault(int(z // spacing), [0.0] * (len(FIELDS) + 2))
            row[0] += 1
            row[1] += z
            for k, field in enumerate(FIELDS):
                value = float(particle[field])
                row[2 + k] += value if value == value else 0.0  # above the column's surface there is no exact value
    return [[row[0]] + [value / row[0] for value in row[1:]] for _, row in sorted(rows.items())]


def surface_of(path):
    return max(float(particle["z"]) for particle in rows_of(path))


def evaluate(folder, begin=5.0):
    record = json.loads((folder / "run.json").read_text(encoding="utf-8"))
    manifest = record["manifest"]
    spacing = manifest["initial"]["particles"]["spacing"]
    slope = manifest["plugins"]["equations"]["bed_slope"]
    depth = manifest["plugins"]["turbulence"]["depth"]
    crest = manifest["plugins"]["drag"]["roughness_height"]
    support = 2 * manifest["domain"]["smoothing_ratio"] * spacing
    paths = sorted((folder / "profiles").glob("*.csv"))
    late = [path for path in paths if time_of(path) >= begin] or [folder / "profile.csv"]
    rows = means_of(late, spacing)
    with open(folder / "means.csv", "w", encoding="utf-8") as out:
        out.write("z,u,u_column,tau,virial,tau_column\n")
        for n, z, u, exact, _, tau, tau_exact, virial in rows:
            out.write(f"{z:.6g},{u:.6g},{exact:.6g},{tau:.6g},{virial:.6g},{tau_exact:.6g}\n")
    whole = sum(row[0] for row in rows)
    mean = sum(row[0] * row[2] for row in rows) / whole
    column = sum(row[0] * row[3] for row in rows) / whole
    weight = manifest["fluid"]["density"] * manifest["fluid"]["gravity"] * slope * depth
    inner = [row for row in rows if row[1] < depth - spacing]  # the last row is half in the air
    stress = [(row[1], abs(row[5] - row[6]) / weight) for row in inner if row[1] > crest]
    return {
        "case": record["case"],
        "mean": mean,
        "column": column,
        "velocity": max(abs(row[2] - row[3]) for row in inner) / column,
        "stress": max(value for _, value in stress),
        "stress_beyond": max(value for z, value in stress if z > crest + support),
        "virial": max(abs(row[7]) for row in inner) / weight,
        "rise": (surface_of(late[-1]) - surface_of(paths[0] if paths else late[0])) / depth,
        "across": max(abs(row[4]) for row in inner) / column,
        "cpu": record["cpu_seconds"],
    }


def main():
    print("case      U       column  diff %  u(z) %  tau %  beyond %  virial %  rise %  across %  CPU s")
    for name in sys.argv[1:]:
        e = evaluate(pathlib.Path(name))
        print(f"{e['case']:9} {e['mean']:.4f}  {e['column']:.4f}  {100 * (e['mean'] / e['column'] - 1):+6.2f}  "
              f"{100 * e['velocity']:6.2f} {100 * e['stress']:6.2f} {100 * e['stress_beyond']:9.2f} "
              f"{100 * e['virial']:9.2f} {100 * e['rise']:7.2f} {100 * e['across']:9.2f} {e['cpu']:6.1f}")


if __name__ == "__main__":
    main()
