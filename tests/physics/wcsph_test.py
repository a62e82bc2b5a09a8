"""Weakly compressible flow in the vertical plane: still water, the lock test, the collapse of a column, and that a run
which was stopped goes on bit by bit."""

import csv
import math
import shutil
import sys
from pathlib import Path

from scene import Scene, main

CASES = Path(__file__).resolve().parents[2] / "cases"


def rows(path):
    with open(path) as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(l for l in file if l[0] != "#")]


class WeaklyCompressible(Scene):
    def flow(self, name, *sets, out="out"):
        overrides = [word for text in sets for word in ("--set", text)]
        self.riffle("run", str(CASES / name), "--out", out, "--threads", "1", "--quiet", "--overwrite",
                    *overrides)
        return self.record(self.home / out)

    def velocity(self, record):
        return record["ledger"]["momentum"]["final"][0] / record["ledger"]["mass"]["final"]

    # Pressure of the particles against rho g (H - z): 2 % of that at the bed, which is the compression of c0 = 10 m/s
    # (g H / c0^2 = 1 %) and as much noise. Water at rest: 1 % of c0 at most, where its prototype had 0.8 %.
    def test_still_water_is_hydrostatic_with_either_wall(self):
        for wall in ("dummy-wall", "adami-wall"):
            record = self.flow("hydrostatic/column.toml", "time.end=1", "output.picture=false",
                               f"plugins.walls.id={wall}")
            self.assertEqual(record["status"], "finished")
            off = [row["pressure"] - 9810 * (0.1 - row["z"]) for row in rows(self.home / "out/profile.csv")]
            rms = math.sqrt(sum(p * p for p in off) / len(off))
            print(f"{wall}: rms {rms:.1f} Pa, largest {max(map(abs, off)):.1f} Pa of 981 Pa", file=sys.stderr)
            self.assertLess(rms, 0.02 * 981)
            self.assertLess(record["extrema"]["velocity_z"]["max_abs"], 0.1)
            self.assertLess(abs(record["ledger"]["mass"]["imbalance"]), 1e-13)

    # The same in space, with ten rows, and what a mirror of the tank in itself cannot change: its mean velocity along x, y.
    def test_still_water_in_three_dimensions(self):
        record = self.flow("hydrostatic/tank.toml", "output.picture=false")
        self.assertEqual(record["status"], "finished")
        self.assertEqual(record["errors"]["pressure"]["count"], 2000)
        self.assertLess(record["errors"]["pressure"]["l2"], 0.02)
        for axis in "xyz":
            self.assertLess(record["errors"][f"velocity_{axis}"]["linf"], 0.01)  # 1 % of sqrt(g H)
        for axis in "xy":
            self.assertLess(abs(record["errors"][f"velocity_{axis}"]["mean"]), 1e-12)

    # A layer let go on a slope obeys U = g S0 t exactly. 0.98 is the project's bound for the default kernel; the cubic
    # spline at 1.2 spacings is the documented failure, which pressures relative to still water cure.
    def test_a_layer_on_a_slope_does_not_lock_unless_its_kernel_does(self):
        dynamic = ("plugins.equations.pressure=dynamic", "plugins.equations.reference_level=0.044",
                   "plugins.equations.sound_speed=5")
        cubic = ("plugins.kernel.id=cubic-spline", "domain.smoothing_ratio=1.2")
        found = {}
        for name, sets in (("wendland", ()), ("wendland dynamic", dynamic), ("cubic", cubic),
                           ("cubic dynamic", cubic + dynamic)):
            record = self.flow("lock-test/slope.toml", "output.picture=false", *sets)
            found[name] = self.velocity(record) / (9.81 * 0.004 * record["time"])
        print("lock test U / (g S0 t):", found, file=sys.stderr)
        self.assertGreater(found["wendland"], 0.98)
        self.assertGreater(found["wendland dynamic"], 0.98)
        self.assertLess(found["cubic"], 0.95)
        self.assertGreater(found["cubic dynamic"], 0.96)
        self.assertLess(max(found.values()), 1.01)

    # The reference of the lock test against its own equation, du/dt = g S0 + nu d2u/dz2, by finite differences 0.2 mm apart:
    # their error is 1e-4 of g S0 t. A viscosity a hundred times that of water makes a layer of 9 mm.
    def test_the_sliding_layer_is_held_back_as_its_equation_says(self):
        self.flow("lock-test/slope.toml", "time.end=0.2", "output.picture=false", "reference.viscosity=1e-4")
        nu, dz, cells, dt = 1e-4, 2e-4, 250, 1.6e-4
        u = [0.0] * (cells + 1)
        for _ in range(round(0.2 / dt)):
            up = u[1:] + [u[-2]]  # no stress at the surface
            u = [0.0] + [m + dt * (9.81 * 0.004 + nu * (a - 2 * m + b) / dz**2) for a, m, b in zip(u, u[1:], up[1:])]
        for row in rows(self.home / "out/profile.csv"):
            place = max(row["z"], 0) / dz
            k = min(int(place), cells - 1)
            expected = u[k] + (place - k) * (u[k + 1] - u[k])
            self.assertAlmostEqual(row["velocity_x_exact"], expected, delta=1e-3 * 9.81 * 0.004 * 0.2)

    # Kazemi (2017) eqs 3.20, 3.21 at the places of the particles, above the crest and nowhere else.
    def test_the_logarithmic_law_is_that_of_its_formula(self):
        law = 'reference={ id = "log-law", depth = 0.04, roughness = 0.02, slope = 0.004, datum = 0.01, from = 0.016 }'
        record = self.flow("rough-bed/S004H50.toml", "time.max_steps=1", "output.picture=false", "initial.velocity=[0.2, 0]", law)
        shear = math.sqrt(9.81 * 0.04 * 0.004)
        known = 0
        for row in rows(self.home / "out/profile.csv"):
            if math.isnan(row["velocity_x_exact"]):
                self.assertLess(row["z"], 0.016)
                continue
            known += 1
            z = row["z"] - 0.01
            self.assertAlmostEqual(row["velocity_x_exact"], shear * (math.log(z / 0.02) / 0.41 + 8.5), delta=1e-9)
            self.assertAlmostEqual(row["modelled_shear_stress_exact"], 1000 * shear**2 * (1 - z / 0.04), delta=1e-6)
        self.assertEqual(known, record["errors"]["velocity_x"]["count"])
        self.assertEqual(known, 15 * 17)  # rows from 17 to 49 mm

    # On a lattice 24 others lie within 2.9 spacings, 28 within the skin of the lists, 3.2.
    def test_neighbours_are_those_within_the_support_not_those_of_the_list(self):
        record = self.flow("lock-test/slope.toml", "time.max_steps=1", "domain.smoothing_ratio=1.45", "output.picture=false")
        self.assertEqual(record["neighbours"]["largest"], 24)
        self.assertEqual(record["neighbours"]["smallest"], 14)  # at the surface: walls take part, air does not

    # The front against Martin & Moyce (1952) and Koshizuka & Oka (1996): particles are early, as always without the
    # gate and the friction of the flume; 15 % is what separates the two experiments at most (T = 1.2 to 3).
    def test_the_front_of_a_collapsing_column(self):
        self.flow("dam-break-2d/martin-moyce.toml", "output.picture=false", "initial.particles.spacing=7.3e-3",
                  "output.profiles=0.05", "time.end=0.25", "output.snapshots=0")
        with open(CASES / "dam-break-2d/dambreak_front_martinmoyce_koshizuka.csv") as file:
            data = [(float(r["T"]), float(r["Z"])) for r in csv.DictReader(l for l in file if l[0] != "#")]
        for k, t in enumerate((0.05, 0.1, 0.15, 0.2)):
            scaled = t * math.sqrt(2 * 9.81 / 0.146)
            front = max(row["x"] for row in rows(self.home / f"out/profiles/{k:06}.csv")) / 0.146
            near = sorted(data, key=lambda p: abs(p[0] - scaled))[:3]
            low, high = min(z for _, z in near), max(z for _, z in near)
            print(f"T = {scaled:.2f}: Z = {front:.2f}, measured {low:.2f} to {high:.2f}", file=sys.stderr)
            self.assertGreater(front, 0.85 * low)
            self.assertLess(front, 1.2 * high + 0.1)

    def test_a_periodic_channel_goes_on_bit_by_bit_with_its_averages(self):
        short = ("time.end=0.4", "output.averages=0.02", "output.averages_from=0.1", "output.checkpoint=0.2",
                 "output.picture=false")
        whole = self.flow("lock-test/slope.toml", *short, out="whole")
        shutil.copytree(self.home / "whole", self.home / "half")
        (self.home / "half/run.json").unlink()
        self.riffle("run", "--resume", "half", "--quiet", "--threads", "1")
        half = self.record(self.home / "half")
        self.assertEqual((self.home / "whole/profile.csv").read_text(), (self.home / "half/profile.csv").read_text())
        for key in ("profiles", "stress", "balance"):
            self.assertEqual(whole[key], half[key], key)
        self.assertEqual(whole["profiles"]["samples"], 16)


if __name__ == "__main__":
    main()
