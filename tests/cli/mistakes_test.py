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

    def test_a_bed_or_width_that_is_not_there_throughout_is_shown_where_it_fails(self):
        self.assertIn("bed \"profile\": the level of the bed must be finite throughout the domain",
                      self.refused("--set", "plugins.bed.id=profile", "--set", "plugins.bed.level=sqrt(x-3)"))
        (self.home / "survey.csv").write_text("x,b\n0,0\n50,1\n150,0\n")
        table = str(self.home / "survey.csv")
        self.assertIn("survey.csv", self.refused(
            "--set", "plugins.bed.id=profile",
            "--set", f'plugins.bed.level={{ csv = "{table}", x = "x", value = "b", outside = "error" }}'))
        self.assertIn("width \"profile\": the width of the channel must be above 0 throughout the domain",
                      self.refused("--set", "plugins.width.id=profile", "--set", "plugins.width.width=1-0.01*x"))
        self.assertIn("plugins.width.throat_width", self.refused(
            "--set", "plugins.width.id=contraction", "--set", "plugins.width.throat_width=-1",
            "--set", "plugins.width.center=100", "--set", "plugins.width.half_length=20"))
        self.assertIn("a standard Parshall flume has one of", self.refused(
            "--set", "plugins.bed.id=parshall", "--set", "plugins.bed.throat_width=0.4", "--set", "plugins.bed.crest=100"))

    def test_a_width_that_the_equations_do_not_know_is_refused(self):
        self.assertIn('has no effect: equations "swe-standard" does not read the width of the channel',
                      self.refused("--set", "plugins.width.id=profile", "--set", "plugins.width.width=2"))

    def test_friction_that_would_push_is_refused(self):
        for law, key, value in ("manning", "roughness", -0.01), ("chezy", "coefficient", 0), ("darcy-weisbach", "friction_factor", -1):
            text = self.refused("--set", f"plugins.drag.id={law}", "--set", f"plugins.drag.{key}={value}")
            self.assertIn(f"plugins.drag.{key}", text)

    def test_no_water_is_refused(self):
        for depth in 0, -1:
            self.assertIn("initial.depth is nowhere above 0", self.refused("--set", f"initial.depth={depth}"))

    def test_too_few_particles_for_the_support_are_refused(self):
        self.assertIn('initial.particles must be at least 8 for kernel "cubic-spline" at smoothing_ratio 2',
                      self.refused("--set", "initial.particles.count=7"))

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
