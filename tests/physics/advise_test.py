"""riffle advise --verify on shipped cases: what it proposes, and that measurement bears out what it estimated.

A contribution is the relative L1 difference of the depth between two runs that differ in one term. Estimates are scaling
laws, so they must agree with what is measured on which side of the tolerance (half a per cent) a term falls, and within a factor
of 2.5 where they are fitted (depth ratios 0.1 to 0.7; docs/advising.md)."""
import json

from scene import SOURCE, Scene, main

TOLERANCE = 0.005


class Advise(Scene):
    def advice(self, case, *more):
        said = self.riffle("advise", SOURCE / "cases" / case, "--json", "--verify", *more)
        advice = json.loads(said.stdout)
        self.terms = {term["name"]: term for term in advice["terms"]}
        for term in advice["terms"]:
            self.assertEqual(term.get("problem", ""), "", term["name"])
            if term["measured"] is not None and term["obstacle"] == "":
                self.assertEqual(term["kept"] or term["name"] == "twice as many particles", term["measured"] > TOLERANCE
                                 or term["name"] == "twice as many particles", term)
        return advice

    def test_waves_behind_an_undular_bore_need_vertical_acceleration(self):
        advice = self.advice("boussinesq/r0.7.toml")
        term = self.terms["vertical acceleration"]
        self.assertTrue(term["matters"])
        self.assertTrue(1 / 2.5 < term["measured"] / term["estimate"] < 2.5, term)
        self.assertIn("plugins.equations.id=serre", advice["set"])

    def test_a_bore_that_breaks_does_not_early_on(self):
        advice = self.advice("boussinesq/r0.1.toml", "--set", "time.end=5")
        term = self.terms["vertical acceleration"]
        self.assertFalse(term["matters"])
        self.assertTrue(1 / 2.5 < term["measured"] / term["estimate"] < 2.5, term)
        self.assertIn("plugins.equations.id=swe-ale", advice["set"])
        self.assertLess(term["cpu_seconds_without"], term["cpu_seconds_with"])

    def test_a_lake_at_rest_needs_no_run(self):
        for case in ("step", "hump-perturbed"):
            advice = self.advice(f"lake-at-rest/{case}.toml", "--set", "time.end=1")
            self.assertLess(self.terms["motion"]["measured"], 1e-6)  # the balanced scheme keeps it to round-off
            self.assertIn("time.max_steps=1", advice["set"])

    def test_a_channel_with_friction_keeps_it_and_ends_when_it_is_steady(self):
        advice = self.advice("uniform-channel/friction.toml", "--set", "time.end=120")
        self.assertTrue(self.terms["bed friction"]["kept"])
        self.assertLess(self.terms["time after it is steady"]["measured"], TOLERANCE)
        ends = [change for change in advice["set"] if change.startswith("time.end=")]
        self.assertLess(float(ends[0].split("=")[1]), 120 * 0.7)

    def test_what_no_model_can_keep_is_said_with_the_reason(self):
        self.advice("step/steady.toml", "--tolerance", "0.001", "--set", "time.end=8")
        term = self.terms["vertical acceleration"]
        self.assertFalse(term["kept"])
        self.assertIn("inflow", term["obstacle"])


main()
