#!/usr/bin/env python3
"""Porous scenes, pistons, gates and armour beds that cannot be, refused in one sentence; and what is said of doubtful ones."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from porous_test import run  # noqa: E402


class Mistakes(unittest.TestCase):
    def refused(self, case, words, *settings):
        """In one line that holds the words."""
        text = run(case, *settings, code=2)
        self.assertIn(words, text)
        self.assertEqual(text.count("\n"), 1, text)

    def test_regions_that_cannot_be_are_refused_in_one_sentence(self):
        for regions, words in (("0.5: 0 0, 1 1, 1 0, 0 1", "crosses itself"),
                               ("0: 0 0, 1 0, 1 1", "porosity must be above 0 and at most 1"),
                               ("1.5: 0 0, 1 0, 1 1", "porosity must be above 0 and at most 1"),
                               ("0.5: 0 0, 0.4 0, 0.4 0.1, 0 0.1; 0.4: 0.3 0, 0.6 0, 0.6 0.1, 0.3 0.1", "overlaps region 1"),
                               ("0.5: 200 0, 400 0, 400 100, 200 100", "corners are in metres"),
                               ("0.5: 0 0, 1 0", "at least 3 corners")):
            self.refused("porous-still/column.toml", words, f'plugins.porosity.regions="{regions}"')

    def test_sizes_that_cannot_be_are_refused_in_one_sentence(self):
        still = "porous-still/column.toml"
        self.refused(still, "grain_diameter", "plugins.drag.grain_diameter=0")
        self.refused(still, "millimetres?", "plugins.drag.grain_diameter=15.9")
        self.refused(still, "millimetres?", "plugins.porosity.thickness=15.9")
        for phi in ("1.2", "0", "-0.1", "x - 0.1"):
            self.refused("seepage/crushed-rock.toml", "porosity must be above 0 and at most 1",
                         f'plugins.porosity.porosity="{phi}"')

    def test_a_piston_that_cannot_move_so_is_refused(self):
        wave = "breakwater/smooth.toml"
        self.refused(wave, "stroke of the piston", "plugins.piston.height=3", "plugins.piston.depth=0.1")
        self.refused(wave, "millimetres?", "plugins.piston.depth=400")
        self.refused(wave, "needs displacement", "plugins.piston.law=displacement")
        self.refused(wave, "displacement is for law", "plugins.piston.displacement=0.1*t")

    def test_channels_that_are_over_or_under_determined_are_refused(self):
        bed = "armour-bed/B1-Q60.toml"
        self.refused(bed, "give two", "reference.discharge=0.0667")
        self.refused(bed, "flow_rate needs the width", "reference.flow_rate=0.06")
        self.refused(bed, "need bottom < trough < crest", "reference.trough=0.0876", "reference.crest=0.0366")
        self.refused(bed, "must stand above the crest", "reference.level=0.06")
        self.refused(bed, "would leave the roughness layer", "reference.middle=0.04")
        self.refused(bed, "millimetres?", "reference.grain_diameter=13.6")
        self.refused(bed, "millimetres?", "plugins.porosity.trough=36.6", "plugins.porosity.crest=87.6")
        self.refused(bed, "above the crest", "reference.length_offset=0.06")
        self.refused(bed, "slope must be above 0", "reference.slope=0")

    def test_a_gate_must_stand_in_the_tank_and_dry(self):
        dam = "porous-dam/crushed-rock.toml"
        gate = ("plugins.gate.kind=boundary", "plugins.gate.id=gate", "plugins.gate.opening_time=0.1")
        self.refused(dam, "there is water in the gate", *gate, "plugins.gate.position=0.281", "plugins.gate.thickness=0.019")
        self.refused(dam, "must stand within the domain", *gate, "plugins.gate.position=0.88", "plugins.gate.thickness=0.02")
        self.refused(dam, "holds no row", *gate, "plugins.gate.position=0.281", "plugins.gate.thickness=0.002")


class Warnings(unittest.TestCase):
    def said(self, case, *settings):
        return {v["text"] for v in run(case, *settings)["verdicts"] if v["name"] == "scene"}

    def test_what_is_doubtful_about_an_armour_bed_is_said(self):
        short = ("time.max_steps=1", "initial.velocity=[0, 0]", "reference.flow_rate=0.06", "reference.flume_width=0.9")
        said = " ".join(self.said("armour-bed/B1-Q60.toml", *short))
        for words in ("middle is not given", "% low; begin with velocity", "a width of 1.37 m"):
            self.assertIn(words, said)

    def test_nothing_is_said_of_a_bed_that_leaves_nothing_open(self):
        self.assertEqual(self.said("armour-bed/B1-Q60.toml", "time.max_steps=1", "reference.middle=0.0621"), set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
