"""Where weakly compressible flow fails: what is refused before the first step, what is warned of, and what ends a run
that has blown up although none of its numbers is infinite."""
import sys

from scene import SOURCE, Scene, main

CASES = SOURCE / "cases"


class Failures(Scene):
    def flow(self, name, *sets, out="out", code=0):
        overrides = [word for text in ("output.picture=false", *sets) for word in ("--set", text)]
        done = self.riffle("run", CASES / name, "--out", out, "--threads", "1", "--quiet", "--overwrite", *overrides, code=code)
        return done.stderr

    def one_line(self, name, *sets):
        said = self.flow(name, *sets, code=2)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertFalse((self.home / "out").exists(), "something was written")
        return said

    # 1.6 times l / (c0 + u) is stable in this scene, 2 is not: the water is faster than three times sound after 0.1 s.
    # Without a verdict the steps shrink until nothing moves on.
    def test_a_run_beyond_its_courant_number_ends_at_once_and_says_what_held_the_step(self):
        said = self.flow("lock-test/slope.toml", "time.cfl=2", code=1)
        record = self.record(self.home / "out")
        print(said, file=sys.stderr)
        self.assertEqual(record["status"], "failed")
        self.assertRegex(record["message"], r"^t = 0\.\d+ s, step \d+: blown up: the water moves at .* limited by wcsph: acoustic$")
        self.assertLess(record["cpu_seconds"], 1)
        self.assertTrue((self.home / "out/failed.hdf").exists())

    def test_a_field_that_nobody_gives_cannot_be_written(self):
        self.assertIn('output.fields: no plugin of this case gives "velocitty"; did you mean "velocity"?',
                      self.one_line("lock-test/slope.toml", 'output.fields=["velocitty"]'))
        self.assertIn('output.fields: "kernel" is a number of pairs', self.one_line("lock-test/slope.toml", 'output.fields=["kernel"]'))

    def test_a_bed_thicker_than_the_water_is_refused(self):
        self.assertIn("plugins.drag.roughness_height must be below the depth of the water, 0.05 m, got 0.06 m",
                      self.one_line("rough-bed/S004H50.toml", "plugins.drag.roughness_height=0.06"))

    def test_a_distance_to_walls_where_there_are_none_is_refused(self):
        self.assertIn('turbulence "mixing-length" reads the distance to the nearest wall, and this scene has no walls',
                      self.one_line("seepage/glass-beads.toml", "plugins.turbulence.id=mixing-length"))

    def test_a_period_that_is_no_multiple_of_the_spacing_is_refused(self):
        self.assertIn("the period of 0.031000 m must be a multiple of the particle spacing, and is 15.500000 of it",
                      self.one_line("rough-bed/S004H50.toml", "domain.x=[0, 0.031]"))

    # (g H) / c0^2 = 0.49 m2/s2 / 25 m2/s2 = 2 %; 50 mm at 4 mm are 12 rows (of 48 mm).
    def test_slow_sound_and_few_rows_are_warned_of(self):
        brief = ("time.max_steps=1", "plugins.equations.sound_speed=5")
        self.assertRegex(self.flow("lock-test/slope.toml", *brief),
                         r"^warning: a speed of sound of 5 m/s lets the density vary by 2 %: ten times sqrt\(g H\) of water "
                         r"0.05 m deep, 7.0\d* m/s, keeps it within 1 %\n$")
        said = self.flow("lock-test/slope.toml", "time.max_steps=1", "plugins.equations.sound_speed=7.1", "domain.x=[0, 0.04]",
                         "initial.particles.spacing=0.004")
        self.assertRegex(said, r"^warning: only 12 rows of particles over 0.048 m of water[^\n]*fewer than 20[^\n]*\n$")
        notes = {v["name"]: v for v in self.record(self.home / "out")["verdicts"]}
        self.assertEqual((notes["rows"]["severity"], notes["rows"]["value"], notes["rows"]["bound"]), ("note", 12, 20))
        self.assertNotIn("sound-speed", notes)


if __name__ == "__main__":
    main()
