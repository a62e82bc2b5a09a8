"""riffle advise: what it prints, what its proposal does, and what it says to bad input."""
import json
import subprocess

from scene import PROGRAM, SOURCE, Scene, main


TANK = """
[case]
name = "tank"
[domain]
dimension = 2
x = [0, "{length} m"]
z = [0, "0.2 m"]
smoothing_ratio = 1.5
[initial]
particles = {{ spacing = "10 mm" }}
inside = "{inside}"
[plugins.equations]
id = "wcsph"
sound_speed = "{sound} m/s"
[plugins.kernel]
id = "wendland-c2"
[plugins.walls]
kind = "boundary"
id = "mirror-wall"
z_min = true
z_min_position = 0
[time]
end = "0.3 s"
integrator = "semi-implicit-euler"
"""


class Advise(Scene):
    def advice(self, case, *more):
        return json.loads(self.riffle("advise", SOURCE / "cases" / case, "--json", *more).stdout)

    def test_words_name_figures_terms_and_a_command(self):
        said = self.riffle("advise", SOURCE / "cases/boussinesq/r0.7.toml").stdout
        for part in ("largest Froude number", "vertical acceleration", "needed", "the least model", "riffle run "):
            self.assertIn(part, said)
        self.assertFalse(list(self.home.iterdir()), "advise leaves nothing behind")

    def test_the_proposed_command_runs(self):
        said = self.riffle("advise", SOURCE / "cases/lake-at-rest/step.toml").stdout
        command = next(line for line in said.splitlines() if line.startswith("  riffle run "))
        command = command.strip().replace("riffle run", f"{PROGRAM} run --quiet --out lake", 1)
        subprocess.run(command, shell=True, cwd=self.home, check=True, capture_output=True)
        self.assertEqual(self.record(self.home / "lake")["steps"], 1)  # water at rest needs no more

    def test_the_proposal_in_json_is_that_in_words(self):
        short = ("--set", "time.end=20")
        advice = self.advice("uniform-channel/friction.toml", *short)
        said = self.riffle("advise", SOURCE / "cases/uniform-channel/friction.toml", *short).stdout
        for change in advice["set"]:
            self.assertIn(f"--set {change}", said)
        self.assertGreater(advice["figures"]["roughness_over_depth"], 0)

    def test_overrides_change_the_scene_that_is_judged(self):
        froude = [self.advice("dam-break/wet-0.5.toml", "--set", f"initial.velocity={u}")["figures"]["froude_number"]
                  for u in (0, 10)]
        self.assertGreater(froude[1], froude[0] + 0.5)

    def test_a_tolerance_decides_what_matters(self):
        for tolerance, matters in ((0.5, False), (1e-4, True)):
            terms = self.advice("boussinesq/r0.7.toml", "--tolerance", tolerance)["terms"]
            self.assertEqual(terms[0]["name"], "vertical acceleration")
            self.assertEqual(terms[0]["matters"], matters)

    def test_waves_below_the_tolerance_are_named(self):
        notes = self.advice("dispersion/sinusoidal.toml")["notes"]
        self.assertIn("--tolerance 3e-05", notes[0])
        advice = self.advice("dispersion/sinusoidal.toml", "--tolerance", "3e-6")
        self.assertTrue(advice["terms"][0]["kept"])  # vertical acceleration, at k h = 1

    def test_the_names_of_tables_may_be_any(self):
        text = (SOURCE / "cases/uniform-channel/friction.toml").read_text()
        text = text.replace("[plugins.drag]", '[plugins.bottom]\nkind = "drag"')
        (self.home / "named.toml").write_text(text)
        advice = json.loads(self.riffle("advise", "named.toml", "--json", "--verify", "--set", "time.end=20").stdout)
        friction = next(term for term in advice["terms"] if term["name"] == "bed friction")
        self.assertGreater(friction["measured"], 0.005)
        self.assertTrue(friction["kept"])

    def tank(self, inside, sound, *more, length=0.2):
        (self.home / "tank.toml").write_text(TANK.format(inside=inside, sound=sound, length=length))
        return json.loads(self.riffle("advise", "tank.toml", "--json", *more).stdout)

    def test_a_collapsing_column_is_driven_and_needs_all(self):
        advice = self.tank("z < 0.1 && x < 0.1", 12)
        figures = advice["figures"]
        self.assertAlmostEqual(figures["mean_depth"], 0.1, delta=1e-9)
        self.assertGreater(figures["driving"], 0.05)
        self.assertEqual(advice["terms"][0]["name"], "change along the flow")
        self.assertTrue(advice["terms"][0]["kept"])
        self.assertEqual(advice["manifest"], "")
        depth = next(term for term in advice["terms"] if term["name"] == "vertical acceleration")
        self.assertGreater(depth["estimate"], 0.1)  # the column is as high as it is long

    def test_shallow_water_in_the_vertical_plane_is_proposed_as_a_channel(self):
        advice = self.tank("z < (x < 1.5 ? 0.08 : 0.06)", 10, "--tolerance", "0.05", length=3)
        self.assertIn("depth = { x = [1.5], values = [0.08, 0.06] }", advice["manifest"])
        (self.home / "channel.toml").write_text(advice["manifest"])
        sets = [word for change in advice["set"] for word in ("--set", change)]
        self.riffle("run", "channel.toml", "--quiet", "--out", "channel", *sets, "--set", "output.picture=false")
        self.assertEqual(self.record(self.home / "channel")["status"], "finished")

    def test_more_sound_than_ten_times_the_fastest_wave_is_too_much(self):
        sound = [change for change in self.tank("z < 0.1 && x < 0.1", 60)["set"] if "sound_speed" in change]
        self.assertEqual(len(sound), 1)
        self.assertLess(float(sound[0].split("=")[1]), 30)

    def test_mistakes_are_one_line_each(self):
        self.assertIn("no such manifest", self.riffle("advise", "nothing.toml", code=2).stderr)
        said = self.riffle("advise", self.case(), "--set", "plugins.viscosity.alfa=1", code=2).stderr
        self.assertIn('did you mean "alpha"?', said)
        self.assertEqual(said.count("\n"), 1)
        self.assertIn("--tolerance", self.riffle("advise", self.case(), "--tolerance", "2", code=2).stderr)


main()
