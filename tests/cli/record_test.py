"""What a run leaves: the files and keys that docs/run-record.md promises."""
import json

from scene import Scene, main


class Record(Scene):
    def test_a_run_writes_its_documented_files(self):
        out = self.run_case("out", "--set", "output.snapshots=0.2", "--set", "output.profiles=0.3", "--set",
                            "output.checkpoint=0.25")
        for name in ("run.json", "log.txt", "manifest.toml", "snapshots.hdf.series", "snapshots/000000.hdf", "profile.csv",
                     "profiles/000000.csv", "checkpoint.h5"):
            self.assertTrue((out / name).exists(), name)
        self.assertEqual([p for p in out.rglob("*.part")], [])
        series = json.loads((out / "snapshots.hdf.series").read_text())
        self.assertEqual([round(f["time"], 9) for f in series["files"]], [0, 0.2, 0.4, 0.6])

    def test_the_record_holds_what_scripts_rely_on(self):
        record = self.record(self.run_case("out", "--set", "plugins.viscosity.alpha=1.5"))
        for key in ("status", "case", "time", "steps", "particles", "wall_seconds", "cpu_seconds",
                    "particle_steps_per_second", "evaluations_per_second", "errors", "extrema", "ledger", "dt_limiters",
                    "plugins", "verdicts"):
            self.assertIn(key, record)
        self.assertEqual(record["status"], "finished")
        self.assertEqual(record["time"], 0.6)
        self.assertEqual(set(record["errors"]["depth"]) >= {"l1", "l2", "linf"}, True)
        self.assertLessEqual(abs(record["ledger"]["mass"]["imbalance"]), 1e-14)
        self.assertEqual(record["overrides"][-1], "plugins.viscosity.alpha=1.5")
        alpha = [p for p in record["plugins"] if p["id"] == "monaghan"][0]["parameters"]["alpha"]
        self.assertEqual(alpha, 1.5)
        for plugin in record["plugins"]:
            self.assertEqual(len(plugin["hash"]), 64)
        self.assertEqual(record["fronts"]["dam"], 100)  # of Stoker's solution with 10 m and 5 m of water; 0.5 m apart
        self.assertAlmostEqual(record["plateau"], 7.2692, delta=0.1)
        self.assertAlmostEqual(record["fronts"]["mid"], 9.354 * record["time"], delta=1)
        self.assertAlmostEqual(sum(limit["share"] for limit in record["dt_limiters"].values()), 1)

    def test_a_run_that_is_finite_and_wrong_is_suspect_and_strict_says_so_in_its_exit_code(self):
        # twenty times the stable step: particles fly apart without a single NaN
        out = self.run_case("out", "--set", "time.step=0.5", "--set", "time.end=60", "--strict", code=3)
        record = self.record(out)
        self.assertEqual(record["status"], "suspect")
        self.assertIn("lost-neighbours", [v["name"] for v in record["verdicts"] if v["severity"] == "suspect"])


if __name__ == "__main__":
    main()
