"""Studies: what riffle compare runs, skips, resumes and refuses."""
import csv
import json
import os
import random
import re
import resource
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

from scene import PROGRAM, SOURCE, Scene, main

STUDY = """
[study]
name = "small"
cases = "{case}"
error = ["errors.depth.l1", "errors.velocity.l2"]
pictures = false
{more}
[set]
time.end = 1
[resolution]
initial.particles.count = [100, 200]
[closures."no viscosity"]
plugins.viscosity.id = "none"
[closures.Monaghan]
plugins.viscosity.alpha = 1
{tables}
"""


def coarsest(text):
    """The study with the first of its resolutions alone."""
    def first(line):
        key, values = line.split(" = ", 1)
        return f"{key} = [{json.dumps(tomllib.loads('values = ' + values)['values'][0])}]"
    section = re.search(r"^\[resolution\].*\n((?:\S+ = .*\n)+)", text, re.M)
    return text.replace(section[1], "".join(first(line) + "\n" for line in section[1].splitlines()))


class Compare(Scene):
    def study(self, more="", tables="", name="small.toml", text=STUDY):
        (self.home / name).write_text(text.format(case=self.case(), more=more, tables=tables))
        return name

    def rows(self, folder="studies/small"):
        with open(self.home / folder / "results.csv", newline="") as file:
            return list(csv.DictReader(file))

    def mistakes(self, name, *more):
        return self.riffle("compare", name, *more, code=2).stderr.strip().replace(f"{name}:", "", 1)

    def test_the_product_is_run_and_tabled(self):
        said = self.riffle("compare", self.study(more='baseline = "Monaghan"'))
        rows = self.rows()
        self.assertEqual([(r["closure"], r["count"]) for r in rows],
                         [("no viscosity", "100"), ("no viscosity", "200"), ("Monaghan", "100"), ("Monaghan", "200")])
        for row in rows:
            self.assertEqual(row["state"], "finished")
            self.assertGreater(float(row["errors.depth.l1"]), 0)
            self.assertGreater(float(row["cpu_seconds"]), 0)
        self.assertIn("4 combinations, 4 finished", said.stdout)
        tables = (self.home / "studies/small/results.md").read_text()
        for part in ("Order of convergence", "The Pareto front", 'Against the baseline "Monaghan"'):
            self.assertIn(part, tables)

    def test_the_command_of_a_row_repeats_its_run(self):
        self.riffle("compare", self.study())
        row = self.rows()[3]
        command = row["command"].replace("riffle run", f"{PROGRAM} run --quiet --out again", 1)
        subprocess.run(command, shell=True, cwd=self.home, check=True, capture_output=True)
        self.assertEqual(self.record(self.home / "again")["errors"]["depth"]["l1"], float(row["errors.depth.l1"]))

    def test_the_same_study_twice_has_the_same_errors_and_repeats_show_the_spread_of_timings(self):
        name = self.study(more="repeats = 3\nthreads = [1, 2]")
        errors = []
        for folder in ("a", "b"):
            self.riffle("compare", name, "--out", folder, "--quiet")
            rows = self.rows(folder)
            errors.append([(r["closure"], r["count"], r["errors.depth.l1"], r["errors.velocity.l2"]) for r in rows])
            for row in rows:
                self.assertEqual((row["repeats"], row["same_bits"]), ("3", "yes"))
                low, middle, high = (float(row["cpu_seconds" + end]) for end in (".min", "", ".max"))
                self.assertTrue(0 < low <= middle <= high)
        self.assertEqual(errors[0], errors[1])
        self.assertEqual(errors[0][0::2], errors[0][1::2])  # any number of threads

    def test_what_is_done_is_not_done_again(self):
        name = self.study()
        self.riffle("compare", name)
        before = {path: path.stat().st_mtime_ns for path in self.home.glob("studies/small/runs/*/run.json")}
        self.assertEqual(len(before), 4)
        said = self.riffle("compare", name)
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)
        self.assertEqual(said.stderr, "")
        # another alpha is another run, and only that
        (self.home / name).write_text((self.home / name).read_text().replace("alpha = 1", "alpha = 2"))
        self.assertEqual(self.riffle("compare", name).stderr.count("depth.l1"), 2)
        self.assertEqual(len(list(self.home.glob("studies/small/runs/*/run.json"))), 6)

    def test_killed_at_any_moment_it_goes_on_with_what_is_missing(self):
        name = self.study(more="repeats = 10")
        dice = random.Random(5)
        kept = {}
        for _ in range(6):
            process = self.start("compare", name, "--cores", "2")
            time.sleep(dice.uniform(0.1, 1.2))
            process.send_signal(signal.SIGKILL)
            process.communicate()
            now = {path: path.stat().st_mtime_ns for path in self.home.glob("studies/small/runs/*/run.json")}
            for path, when in kept.items():
                self.assertEqual(now.get(path), when, "a finished run was done again")
            kept = now
        self.riffle("compare", name, "--quiet")
        records = list(self.home.glob("studies/small/runs/*/run.json"))
        self.assertEqual(len(records), 40)
        for path, when in kept.items():
            self.assertEqual(path.stat().st_mtime_ns, when, "a finished run was done again")
        self.assertEqual([r["repeats"] for r in self.rows()], ["10"] * 4)

    def test_children_die_with_a_study_that_is_killed(self):
        name = self.study(text=STUDY.replace("[100, 200]", "[20000]"))
        process = self.start("compare", name)
        running = self.home / "studies/small/runs"
        for _ in range(600):
            if list(running.glob("*/log.txt")):
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        mine = str(self.home)
        for _ in range(200):
            left = [p for p in os.listdir("/proc") if p.isdigit() and self.works_in(p, mine)]
            if not left:
                return
            time.sleep(0.05)
        self.fail(f"still running: {left}")

    @staticmethod
    def works_in(process, folder):
        try:
            return os.readlink(f"/proc/{process}/cwd") == folder and Path(f"/proc/{process}/stat").read_text().split()[2] != "Z"
        except OSError:
            return False

    def test_a_run_that_fails_or_takes_too_long_is_a_result(self):
        name = self.study(more='time_limit = "2 s"', tables='[closures."tiny steps"]\ntime.step = 1e-8\n'
                          '[closures."drag in huge steps"]\ntime.step = 0.5\ntime.end = 20\ntime.drag = "explicit"\nplugins.friction.kind = "drag"\n'
                          'plugins.friction.id = "manning"\nplugins.friction.roughness = 1\n')
        self.riffle("compare", name)
        state = {(r["closure"], r["count"]): r for r in self.rows()}
        self.assertEqual(state["tiny steps", "200"]["state"], "too slow")
        self.assertIn("stopped after", state["tiny steps", "200"]["message"])
        blown = state["drag in huge steps", "200"]
        self.assertEqual(blown["state"], "blew up")
        self.assertRegex(blown["message"], r"^t = .* no longer finite")
        self.assertEqual(state["Monaghan", "200"]["state"], "finished")
        self.assertIn("## Not good", (self.home / "studies/small/results.md").read_text())

    def test_meaningless_combinations_are_skipped_with_the_reason(self):
        name = self.study(text='[study]\nname = "small"\ncases = "{case}"\npictures = false\n{more}{tables}[set]\ntime.end = 0.1\n'
                          'initial.particles.count = 100\n[vary]\nplugins.viscosity.id = ["none", "monaghan"]\n'
                          'plugins.viscosity.alpha = [1, 2]\n')
        said = self.riffle("compare", name)
        self.assertIn('skipped: wet-0.5, viscosity = none, alpha = 1: viscosity "none" has no parameter "alpha"', said.stderr)
        self.assertEqual(len(self.rows()), 2)

    def test_mistakes_are_one_line_at_their_place(self):
        end = STUDY.format(case="", more="", tables="").count("\n") + 1
        self.assertEqual(self.mistakes(self.study(tables="[vary]\nplugins.viscosity.alfa = [1]\n")),
                         f'{end}:27: viscosity "monaghan" has no parameter "alfa"; did you mean "alpha"?')
        self.assertIn('the baseline "Monahan" is not in the study; did you mean "Monaghan"?', self.mistakes(self.study(more='baseline = "Monahan"')))
        self.assertIn("more than study.runs_at_most = 3; --yes runs them all the same", self.mistakes(self.study(more="runs_at_most = 3")))
        self.assertIn("the study would have no runs", self.mistakes(self.study(tables="[vary]\ntime.cfl = []\n")))
        self.assertIn('no case has "errors.dept.l1"; did you mean "errors.depth.l1"?',
                      self.mistakes(self.study(text=STUDY.replace("errors.depth.l1", "errors.dept.l1"))))
        self.assertFalse((self.home / "studies").exists(), "a study with mistakes leaves nothing")

    def test_the_list_of_jobs_does_the_study(self):
        name = self.study()
        jobs = self.riffle("compare", name, "--launcher", "print").stdout
        self.assertEqual(jobs.count("\n"), 4)
        subprocess.run(["bash", "-e"], input=jobs, text=True, cwd="/", check=True, capture_output=True)
        said = self.riffle("compare", name, "--collect")
        self.assertIn("4 combinations, 4 finished", said.stdout)

    def test_the_study_itself_costs_at_most_a_twentieth_of_its_runs(self):
        # Fifty short runs of an eighth of a second, in ten lines over five resolutions. What a study does besides is what it
        # does again when all runs have ended, measured in CPU time, which others on the machine do not lengthen.
        name = self.study(text=STUDY.replace("[100, 200]", "[1200, 1400, 1600, 1800, 2000]").replace("time.end = 1", "time.end = 6")
                          .replace(', "errors.velocity.l2"', ""),
                          tables='[vary]\nplugins.kernel.id = ["cubic-spline", "quintic-spline", "wendland-c2", "wendland-c4", "gaussian"]\n')

        def seconds():
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.riffle("compare", name, "--quiet")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        whole, own = seconds(), seconds()
        self.assertEqual(len(self.rows()), 50)
        self.assertLess(own, 0.05 * (whole - own), f"{own:.2f} s beside {whole - own:.2f} s of runs")
        print(f"{own:.2f} s beside {whole - own:.2f} s of runs", file=sys.stderr)

    def test_shipped_studies_run_for_a_moment_at_their_coarsest_resolution(self):
        for source in sorted((SOURCE / "cases").glob("*/*.study.toml")):
            text = source.read_text()
            if "[resolution]" not in text:
                continue
            with self.subTest(study=f"{source.parent.name}/{source.name}"):
                closures = len(re.findall(r"^\[closures", text, re.M))
                text = re.sub(r'"([^"]+\.(?:toml|csv))"', lambda m: f'"{source.parent / m[1]}"', text)
                text = coarsest(text)
                text = re.sub(r"^pictures = .*\n", "", text, flags=re.M).replace("[study]", "[study]\npictures = false", 1)
                text = re.sub(r"^time\.end = .*\n", "", text, flags=re.M)
                text = text.replace("[set]", "[set]\ntime.end = 0.1", 1) if "[set]" in text else text + "\n[set]\ntime.end = 0.1\n"
                name = f"{source.parent.name}-{source.name}"
                (self.home / name).write_text(text)
                self.riffle("compare", name, "--out", name + ".out", "--quiet")
                rows = self.rows(name + ".out")
                self.assertGreaterEqual(len(rows), closures)
                self.assertEqual(len({r["closure"] for r in rows}), closures, "a closure is skipped in every case")
                # without viscosity, or on so few particles: suspect; where it is ill-posed: blown up
                self.assertLessEqual({r["state"] for r in rows if "ill-posed" not in r["closure"]}, {"finished", "suspect", "blew up"})
                good = [r for r in rows if r["state"] in ("finished", "suspect")]
                self.assertGreaterEqual(len(good), 0.8 * len(rows))
                self.assertTrue(all(float(r["cpu_seconds"]) > 0 for r in good))


if __name__ == "__main__":
    main()
