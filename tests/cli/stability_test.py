"""Maps of stability: classes, pictures, resumption, mistakes."""
import csv
import re
import sys

from scene import SOURCE, Scene, main

STUDY = """
[study]
name = "map"
cases = "{case}"
pictures = false
time_limit = "60 s"
[set]
time.end = 20
time.drag = "explicit"
initial.particles.count = 50
plugins.friction.kind = "drag"
plugins.friction.id = "manning"
[map]
error_bound = {bound}
x = {{ key = "{key}", from = 0.05, to = 1.2, points = 6 }}
y = {{ key = "time.step", from = 0.05, to = 0.8, points = 6, scale = "logarithmic" }}
"""


class Stability(Scene):
    def study(self, key="plugins.friction.roughness", bound=1e9, text=STUDY):
        (self.home / "map.toml").write_text(text.format(case=self.case(), key=key, bound=bound))
        return "map.toml"

    def rows(self, name="wet-0.5"):
        with open(self.home / "studies" / "map" / f"{name}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_explicit_drag_blows_up_where_step_and_roughness_are_large_and_roughness_has_its_range(self):
        said = self.riffle("stability", self.study())
        rows = self.rows()
        self.assertEqual(len(rows), 36)
        at = {(float(r["plugins.friction.roughness"]), float(r["time.step"])): r for r in rows}
        steps, roughnesses = sorted({step for _, step in at}), sorted({n for n, _ in at})
        self.assertEqual(at[roughnesses[0], steps[0]]["class"], "good")
        self.assertEqual(at[roughnesses[-2], steps[-1]]["class"], "blew up")
        self.assertRegex(at[roughnesses[-2], steps[-1]]["message"], r"^t = ")
        # Manning's n ends at 1
        self.assertEqual({at[roughnesses[-1], step]["class"] for step in steps}, {"refused"})
        self.assertIn("of 36 points run", said.stdout)
        for ending in ("svg", "png"):
            self.assertGreater((self.home / "studies" / "map" / f"wet-0.5.{ending}").stat().st_size, 1000)
        self.assertIn("blew up", (self.home / "studies" / "map" / "stability.md").read_text())
        # done once, done for good
        before = {path: path.stat().st_mtime_ns for path in self.home.glob("studies/map/runs/*/run.json")}
        self.assertEqual(self.riffle("stability", self.study()).stderr, "")
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)

    # On 10 x 10 points, for 400 runs would take 20 s; on 20 x 20 points it is 69 runs (docs/comparing.md). The boundary may be
    # off by one cell.
    def test_the_boundary_of_a_full_grid_is_found_with_fewer_runs(self):
        n = 10
        text = STUDY.replace("points = 6", f"points = {n}").replace("count = 50", "count = 30")
        maps = []
        for search in (n, 4):  # as many points as the grid has: all of them. The second map finds its runs done
            name = self.study(text=text.replace("[map]", f"[map]\nsearch = {search}"))
            said = self.riffle("stability", name, "--quiet").stdout
            runs = int(re.search(r"(\d+) of 100 points run", said)[1])
            maps.append((runs, [r["class"] for r in self.rows()]))
        (all_runs, full), (runs, found) = maps
        self.assertEqual(all_runs, n * n)
        self.assertLessEqual(runs, n * n / 2)
        self.assertGreater(len(set(full)), 2)
        near = lambda k: {full[n * y + x] for y in range(max(k // n - 1, 0), min(k // n + 2, n))
                          for x in range(max(k % n - 1, 0), min(k % n + 2, n))}
        far = [k for k in range(n * n) if found[k] not in near(k)]
        print(f"{runs} runs instead of {n * n}, {len(far)} points off by more than a cell", file=sys.stderr)
        self.assertEqual(far, [])

    def test_a_bound_on_the_error_decides_what_is_inaccurate(self):
        self.riffle("stability", self.study(bound=1e-9), "--quiet")
        self.assertEqual({r["class"] for r in self.rows()} & {"good"}, set())
        self.assertIn("inaccurate", {r["class"] for r in self.rows()})

    def test_mistakes_are_one_line_at_their_place(self):
        self.assertEqual(self.riffle("stability", self.study(key="plugins.friction.rougness"), code=2).stderr,
                         'map.toml:15:1: drag "manning" has no parameter "rougness"; did you mean "roughness"?\n')
        many = STUDY.replace("points = 6", "points = 100").replace('name = "map"', 'name = "map"\nruns_at_most = 100')
        self.assertIn("--yes runs them all the same", self.riffle("stability", self.study(text=many), code=2).stderr)

    def test_a_launcher_that_does_not_wait_is_refused(self):
        self.assertIn("--launcher slurm with --wait only", self.riffle("stability", self.study(), "--launcher", "slurm", code=2).stderr)

    # In the vertical plane, where runs are dear: the first of the closures, and some tens of steps.
    def test_shipped_maps_run_on_a_coarse_grid(self):
        for source in sorted((SOURCE / "cases").glob("*/*.study.toml")):
            text = source.read_text()
            if "[map]" not in text:
                continue
            with self.subTest(study=source.name):
                case = source.parent / re.search(r'^cases = "([^"]+)"', text, re.M)[1]
                plane = "dimension = 2" in case.read_text()
                text = re.sub(r'"([^"]+\.toml)"', lambda m: f'"{source.parent / m[1]}"', text)
                text = re.sub(r"(count = )\d+", r"\g<1>60", text)
                points = 3 if plane else 4
                text = re.sub(r", points = \d+", "", text).replace(" to = ", f" points = {points}, to = ")
                if plane:
                    first, _, others = text.partition("\n[closures.")
                    text = first + ("\n[closures." + others.partition("\n[closures.")[0] if others else "")
                    text = re.sub(r"^time\.end = .*$", "time.end = 0.03", text, flags=re.M)
                (self.home / source.name).write_text(text)
                said = self.riffle("stability", source.name, "--out", source.stem, "--quiet")
                self.assertIn(f"of {points * points} points run", said.stdout)


if __name__ == "__main__":
    main()
