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
