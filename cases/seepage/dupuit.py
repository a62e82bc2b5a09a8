#!/usr/bin/env python3
"""The discharge through a porous block, from the profiles of a run, beside that of Dupuit and Forchheimer.

  dupuit.py RUN [FROM]          a row per profile after FROM seconds (1.4), and at the end the mean of the ratio

The levels on both sides are volumes over widths; the discharge in the middle of the block is the mean of m/rho u over its
middle two thirds. Between the levels it must be that of the closed form

  L = int dh / i(Q/h),   i(U) = a U + b U^2,   a = c1 (1-phi)^2/phi^3 nu/(g d^2),   b = c2 (1-phi)/phi^3 / (g d)

when they change slowly. The run must write velocity, porosity, mass and density."""

import csv
import json
import pathlib
import sys

G, NU = 9.81, 1e-6


def rows_of(path):
    with open(path, encoding="utf-8") as lines:
        text = [line for line in lines]
    time = next(float(line.split()[2]) for line in text if line.startswith("# time:"))
    return time, list(csv.DictReader(line for line in text if not line.startswith("#")))


def discharge(up, down, length, phi, grain, c1, c2):
    """Of the closed form, by bisection on the length that it needs. Metres."""
    a, b = c1 * (1 - phi)**2 / phi**3 * NU / (G * grain**2), c2 * (1 - phi) / phi**3 / (G * grain)

    def needed(q):
        n = 400
        return sum((up - down) / n / (a * q / h + b * (q / h)**2) for h in
                   (down + (up - down) * (k + 0.5) / n for k in range(n)))

    low, high = 1e-9, 10.0
    for _ in range(80):
        middle = (low * high)**0.5
        low, high = (middle, high) if needed(middle) > length else (low, middle)
    return low


def main(run, start=1.4):
    run = pathlib.Path(run)
    record = json.loads((run / "run.json").read_text())
    manifest = record["manifest"]
    drag = next(p["parameters"] for p in record["plugins"] if p["kind"] == "drag")
    text = next(p["parameters"] for p in record["plugins"] if p["kind"] == "porosity")["regions"]
    phi, corners = text.split(":")
    x = [float(corner.split()[0]) for corner in corners.split(",")]
    left, right, low, high = min(x), max(x), manifest["domain"]["x"][0], manifest["domain"]["x"][1]
    near, far = left + (right - left) / 6, right - (right - left) / 6
    print("t [s]  level before, behind [m]  Q, of the closed form [m2/s]  ratio")
    ratios = []
    for path in sorted((run / "profiles").glob("*.csv")) + [run / "profile.csv"]:
        time, rows = rows_of(path)
        if time < start - 1e-9:
            continue
        water = [(float(r["x"]), float(r["mass"]) / float(r["density"]), float(r["velocity_x"])) for r in rows]
        before = sum(v for at, v, _ in water if at < left - 0.02) / (left - 0.02 - low)
        behind = sum(v for at, v, _ in water if at > right + 0.02) / (high - right - 0.02)
        found = sum(v * u for at, v, u in water if near < at < far) / (far - near)
        exact = discharge(before, behind, right - left, float(phi), drag["grain_diameter"], drag["c1"], drag["c2"])
        ratios.append(found / exact)
        print(f"{time:5.2f}  {before:.4f}  {behind:.4f}  {found:.6f}  {exact:.6f}  {found / exact:.3f}")
    print(f"mean ratio {sum(ratios) / len(ratios):.3f}, from {min(ratios):.3f} to {max(ratios):.3f}")


if __name__ == "__main__":
    main(sys.argv[1], *(float(a) for a in sys.argv[2:3]))
