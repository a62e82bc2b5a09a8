"""riffle advise: what it prints, what its proposal does, and what it says to bad input."""
import json
import subprocess

from scene import PROGRAM, SOURCE, Scene, main


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

    def test_the_names_of_tables_may_be_any(self):
        text = (SOURCE / "cases/uniform-channel/friction.toml").read_text()
        text = text.replace("[plugins.drag]", '[plugins.bottom]\nkind = "drag"')
        (self.home / "named.toml").write_text(text)
        advice = json.loads(self.riffle("advise", "named.toml", "--json", "--verify", "--set", "time.end=20").stdout)
        friction = next(term for term in advice["terms"] if term["name"] == "bed friction")
        self.assertGreater(friction["measured"], 0.005)
        self.assertTrue(friction["kept"])

    def test_mistakes_are_one_line_each(self):
        self.assertIn("no such manifest", self.riffle("advise", "nothing.toml", code=2).stderr)
        said = self.riffle("advise", self.case(), "--set", "plugins.viscosity.alfa=1", code=2).stderr
        self.assertIn('did you mean "alpha"?', said)
        self.assertEqual(said.count("\n"), 1)
        self.assertIn("--tolerance", self.riffle("advise", self.case(), "--tolerance", "2", code=2).stderr)


main()
