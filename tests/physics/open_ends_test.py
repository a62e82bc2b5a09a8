"""Open ends of flow in the vertical plane: two depths of the channel over spheres between a discharge and a level, 20 rows.

Bounds: 3 % of the velocity and 0.5 % of the volume per second are what the ends are asked for; one particle is 0.03 % of what
passes in the time of the run. docs/results-rough-bed.md has eight depths over longer times."""
import json
import shutil
from pathlib import Path

from scene import Scene, main

CASES = Path(__file__).resolve().parents[2] / "cases"
DISCHARGE, DEPTH = 0.012196, 0.05


class OpenEnds(Scene):
    def flow(self, *sets, out="out", code=0, case="rough-bed/open-ends.toml"):
        short = ("output.picture=false", "initial.particles.spacing=2.5e-3", "domain.x=[0, 0.1]", "time.end=0.9",
                 "output.averages_from=0.3")
        if not any("inflow-averaged" in s for s in sets) and "rough" in case:
            short += ("plugins.inflow.shape_distance=0",)
        options = [w for s in (*short, *sets) for w in ("--set", s)]
        done = self.riffle("run", CASES / case, "--quiet", "--threads", 1, "--out", self.home / out, "--overwrite",
                           *options, code=code)
        return self.record(self.home / out) if code == 0 else done.stdout + done.stderr

    def test_the_discharge_enters_and_leaves_and_the_flow_stays_uniform(self):
        record = self.flow()
        mass, velocity = record["ledger"]["mass"], record["profiles"]["velocity"]
        entered = mass["in"] / 1000 / record["time"] / DISCHARGE  # the water is 0.3 % denser than at rest
        self.assertAlmostEqual(entered, 1.0025, delta=0.005)
        self.assertLess(abs(mass["in"] - mass["out"]) / mass["in"], 0.005)
        self.assertAlmostEqual(velocity["over_depth"] / (DISCHARGE / DEPTH), 1, delta=0.03)
        self.assertAlmostEqual(record["profiles"]["depth"] / DEPTH, 1, delta=0.01)
        self.assertLess(max(velocity["rms_z"]), 0.02 * velocity["over_depth"])
        self.assertLess(abs(mass["imbalance"]), 1e-13)
        self.assertLess(abs(record["ledger"]["volume"]["change"]), 1e-3)

    # The documented failure: within a second the depth is off by more than the 1 % that the pair above keeps.
    def test_ends_that_impose_nothing_lose_the_level_although_as_much_leaves_as_enters(self):
        record = self.flow("plugins.inflow.id=inflow-averaged", "plugins.outflow.id=outflow-frozen")
        mass = record["ledger"]["mass"]
        self.assertLess(abs(mass["in"] - mass["out"]) / mass["in"], 0.02)
        self.assertGreater(abs(record["profiles"]["depth"] / DEPTH - 1), 0.02)
        self.assertLess(abs(mass["imbalance"]), 1e-13)

    # A short flume of few rows: what the ends do, not what the bed does. A row brings its particles one by one, 1 % each.
    def test_a_porous_inlet_brings_its_discharge_and_the_wall_rises_where_the_surface_falls(self):
        record = self.flow("initial.particles.spacing=0.0141", "domain.x=[0, 0.846]", "time.end=0.8",
                           "plugins.outflow.first_section=0.5", "plugins.outflow.second_section=0.7",
                           "plugins.equations.sound_speed=8", "plugins.outflow.height=0.3", case="armour-bed/open-ends.toml")
        entered = record["ledger"]["mass"]["in"] / 1000 / record["time"] / 0.04372
        self.assertAlmostEqual(entered, 1.01, delta=0.02)  # the water is 1 to 2 % denser than at rest
        wall = [p["state"] for p in record["plugins"] if p["id"] == "outflow-imaginary-wall"]
        self.assertGreater(wall[0][0], 0.3 + 0.01)  # the surface is drawn down at first
        self.assertLess(abs(record["ledger"]["mass"]["imbalance"]), 1e-13)
        self.assertLess(record["extrema"]["velocity_x"]["max"], 1.5)

    def test_still_water_rises_to_the_level_outside(self):
        record = self.flow("plugins.inflow.discharge=0", "plugins.equations.bed_slope=0", "initial.velocity=[0, 0]",
                           "plugins.outflow.level=0.055", "plugins.turbulence.id=none", "output.averages_from=0.9")
        # It oscillates about the level outside; a spacing is 2.5 mm.
        self.assertAlmostEqual(record["profiles"]["depth"], 0.055, delta=0.001)
        self.assertAlmostEqual(record["ledger"]["volume"]["final"] / (0.1 * 0.055), 1, delta=0.02)

    def test_a_run_that_was_stopped_goes_on_bit_by_bit(self):
        short = ("time.end=0.2", "output.checkpoint=0.1")
        self.flow(*short, out="whole")
        shutil.copytree(self.home / "whole", self.home / "half")
        (self.home / "half/run.json").unlink()
        self.riffle("run", "--resume", "half", "--quiet", "--threads", "1")
        self.assertEqual((self.home / "whole/profile.csv").read_text(), (self.home / "half/profile.csv").read_text())
        ledgers = [json.loads((self.home / name / "run.json").read_text())["ledger"] for name in ("whole", "half")]
        self.assertEqual(*ledgers)

    def test_what_makes_no_sense_is_refused_in_one_sentence(self):
        for setting, sentence in (
                ("domain.x=[0, 0.03]", "inflow-discharge: the domain of 0.030000 m must be at least 0.050000 m long"),
                ("plugins.inflow.discharge=-0.01", "the discharge must not be negative, and is -0.010000 m2/s"),
                ("plugins.outflow.level=-0.01", "outflow-level: the level must be above the bed at 0.000000 m"),
                ("plugins.inflow.level=-0.01", "inflow-discharge: the level must be above the bed at 0.000000 m"),
                ("initial.inside=z < 0.002", "the water at its end must be deeper than a particle at t = 0")):
            self.assertIn(sentence, self.flow(setting, code=2))
        for setting, sentence in (
                ("plugins.outflow.first_section=1.9", "search needs first_section upstream of second_section"),
                ("plugins.inflow.level=-1", "inflow-porous: the level must be above the bed"),
                ("plugins.porosity.transition_to=0.05", "an inflow_porosity needs transition_from below transition_to")):
            self.assertIn(sentence, self.flow("domain.x=[0, 2.1714]", "initial.particles.spacing=0.00987", setting,
                                              code=2, case="armour-bed/open-ends.toml"))


if __name__ == "__main__":
    main()
