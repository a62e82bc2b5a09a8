"""Flow over a bed of spheres in a periodic box, against the column model that it starts from.

Bounds: 3 % of the bed stress for the stress and 2 % for the velocity are what the scheme is asked for; 1 % for the rest was
reached with room (docs/results-rough-bed.md has all twelve flows, over longer times)."""
import importlib.util
import sys
from pathlib import Path

from scene import Scene, main

CASES = Path(__file__).resolve().parents[2] / "cases"


def profiles_of_the_cases():
    spec = importlib.util.spec_from_file_location("profiles", CASES / "rough-bed" / "profiles.py")
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


class RoughBed(Scene):
    def run_flow(self, end, *sets, code=0):
        out = self.home / "run"
        options = [w for s in ("output.picture=false", f"time.end={end}", *sets) for w in ("--set", s)]
        done = self.riffle("run", CASES / "rough-bed" / "S004H40.toml", "--quiet", "--threads", 1, "--out", out,
                           "--overwrite", *options, code=code)
        return out if code == 0 else done.stdout + done.stderr

    def mean_velocity(self, folder):
        record = self.record(folder)
        return record["ledger"]["momentum"]["final"][0] / record["ledger"]["mass"]["final"]

    def test_it_keeps_the_velocities_and_the_stresses_of_the_column(self):
        flow = profiles_of_the_cases().evaluate(self.run_flow(3, "output.profiles=0.1"), begin=1)
        self.assertLess(abs(flow["mean"] / flow["column"] - 1), 0.01)
        self.assertAlmostEqual(flow["column"], 0.182, delta=0.0015)  # the table of the column, three digits
        self.assertLess(flow["stress_beyond"], 0.03)
        self.assertLess(flow["virial"], 0.01)
        self.assertLess(abs(flow["rise"]), 0.01)
        self.assertLess(flow["across"], 0.01)

    def test_with_too_narrow_a_support_the_lattice_carries_the_water(self):
        flow = profiles_of_the_cases().evaluate(self.run_flow(3, "output.profiles=0.1", "domain.smoothing_ratio=1.2"), begin=1)
        self.assertGreater(flow["virial"], 0.3)  # 0.7 later on
        self.assertLess(flow["mean"], 0.95 * flow["column"])

    def test_smaller_eddies_alone_do_not_hold_it(self):
        started = self.mean_velocity(self.run_flow(0.001))
        ended = self.mean_velocity(self.run_flow(1.5, "plugins.turbulence.id=smagorinsky"))
        self.assertGreater(ended, 1.05 * started)  # g S0 t is a third of it; the drag grows with the velocity

    def test_three_given_of_two_are_refused_with_what_each_pair_would_give(self):
        text = self.run_flow(1, "reference.discharge=0.01", code=2)
        self.assertIn("channel: discharge, depth and slope are all given; give two. With this bed: (depth, slope) -> "
                      "discharge = 0.00728", text)

    def test_a_depth_within_the_spheres_is_refused(self):
        self.assertIn("do not cover the roughness layer of 0.0114 m", self.run_flow(1, "reference.depth=0.011", code=2))


if __name__ == "__main__":
    main()
