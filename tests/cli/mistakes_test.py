"""A user's mistake costs one clear sentence, exit code 2, and nothing else."""
from scene import SHORT, Scene, main


class Mistakes(Scene):
    def refused(self, *arguments):
        done = self.riffle("run", self.case(), "--quiet", "--out", "out", *SHORT, *arguments, code=2)
        self.assertFalse((self.home / "out").exists(), "something was written")
        return done.stderr

    def test_an_unknown_parameter_is_named_with_the_nearest_right_one(self):
        self.assertIn('did you mean "alpha"', self.refused("--set", "plugins.viscosity.alfa=1"))

    def test_an_unknown_plugin_is_named_with_the_nearest_right_one(self):
        self.assertIn('did you mean "monaghan"', self.refused("--set", "plugins.viscosity.id=monagan"))

    def test_a_value_out_of_range_is_shown_with_its_bounds(self):
        text = self.refused("--set", "plugins.viscosity.alpha=-1")
        self.assertIn("alpha", text)
        self.assertIn("100", text)

    def test_all_mistakes_come_in_one_go(self):
        text = self.refused("--set", "plugins.viscosity.alfa=1", "--set", "time.cfll=0.5")
        self.assertIn("alfa", text)
        self.assertIn("cfll", text)

    def test_a_missing_manifest_is_bad_input(self):
        self.assertIn("nowhere.toml", self.riffle("run", "nowhere.toml", code=2).stderr)

    def test_a_plugin_that_refuses_its_parameters_is_bad_input(self):
        self.assertIn("ritter", self.refused("--set", "reference.depth_right=0"))

    def test_a_run_is_not_overwritten_unless_asked(self):
        first = self.run_case("out")
        before = (first / "run.json").read_bytes()
        self.riffle("run", self.case(), "--quiet", "--out", "out", *SHORT, code=2)
        self.assertEqual((first / "run.json").read_bytes(), before)
        self.run_case("out", "--overwrite")

    def test_resuming_with_other_physics_is_refused(self):
        self.run_case("out", "--set", "output.checkpoint=0.2")
        text = self.riffle("run", "--resume", "out", "--set", "plugins.viscosity.alpha=0.5", code=2).stderr
        self.assertIn("--resume", text)


if __name__ == "__main__":
    main()
