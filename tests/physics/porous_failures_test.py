#!/usr/bin/env python3
"""Where flow in pores fails: short scenes that go wrong, and what notices. Figures are those of docs/stability.md."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from porous_test import run  # noqa: E402


def doubts(record):
    return {v["name"] for v in record["verdicts"] if v["severity"] == "suspect"}


class Failures(unittest.TestCase):
    def test_a_porosity_that_jumps_drives_currents_in_water_at_rest(self):
        # Particles of equal water; a piece of the basin. A transition of the grain diameter is the sound twin.
        piece = ("time.end=1", "domain.x=[0.1, 0.5]", 'initial.particles.placement="equal-volume"')
        sound = run("porous-still/column.toml", *piece)
        wrong = run("porous-still/column.toml", *piece, "plugins.porosity.thickness=1e-4")
        speeds = [r["ledger"]["momentum"]["scale"] / r["ledger"]["mass"]["final"] for r in (sound, wrong)]
        print("mean speed with a transition and without: %.4f, %.4f m/s" % tuple(speeds), file=sys.stderr)
        self.assertGreater(speeds[1], 2 * speeds[0])
        self.assertIn("thinner than the spacing", " ".join(v["text"] for v in wrong["verdicts"]))
        self.assertNotIn("thinner", " ".join(v["text"] for v in sound["verdicts"]))

    def test_particles_of_equal_water_have_too_few_neighbours_in_a_bed_of_gravel(self):
        # phi = 0.22: spacings of 2.1, and 28 neighbours become 6
        first = ("time.max_steps=2", "reference.middle=0.0621")
        record = run("armour-bed/B1-Q60.toml", *first, 'initial.particles.placement="equal-volume"')
        self.assertIn("pores", doubts(record))
        self.assertEqual(doubts(run("armour-bed/B1-Q60.toml", *first)), set())

    def test_stiff_drag_taken_explicitly_blows_up_at_the_step_of_the_flow(self):
        fine = ("plugins.drag.grain_diameter=1e-4", "reference.grain_diameter=1e-4", "time.end=0.01")
        self.assertEqual(run("seepage/crushed-rock.toml", *fine, 'time.drag="explicit"', code=1)["status"], "failed")
        self.assertEqual(run("seepage/crushed-rock.toml", *fine)["status"], "finished")

    def test_a_drag_that_drives_is_impossible(self):
        # eq. 4.57 prints - A_a with an A_a that is negative already; a rate below zero has no way in
        for coefficient in ("c1", "c2"):
            text = run("seepage/crushed-rock.toml", f"plugins.drag.{coefficient}=-1.75", code=2)
            self.assertIn("must be", text)
            self.assertEqual(text.count("\n"), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
