"""A run that goes on from a checkpoint ends bit by bit as the uninterrupted one, however it was interrupted."""
import random
import shutil
import signal
import time

from scene import Scene, main

LONG = ["--set", "initial.particles.count=6000", "--set", "time.end=4", "--set", "output.picture=false", "--threads", "1", "--quiet"]


class Restart(Scene):
    def uninterrupted(self, case, *more):
        """The folder of the whole run, and how many seconds it took."""
        start = time.monotonic()
        self.riffle("run", self.case(case), "--out", "whole", *LONG, *more)
        return self.home / "whole", time.monotonic() - start

    def interrupted(self, case, how, after, *more):
        """Starts a run, sends it a signal and waits for its end; returns its folder, or None when it was over already."""
        process = self.start("run", self.case(case), "--out", "part", *LONG, *more)
        time.sleep(after)
        if process.poll() is not None:
            process.communicate()
            return None
        process.send_signal(how)
        process.communicate(timeout=60)
        return self.home / "part"

    def test_a_checkpoint_of_simulated_time_resumes_to_the_same_bits(self):
        for case in ("wet-0.25", "dry", "best/wet-0.25", "best/dry"):
            with self.subTest(case=case):
                options = ["--set", "output.checkpoint=0.2", "--set", "output.snapshots=0.25"]
                name = case.replace("/", "-")
                whole = self.run_case(f"{name}-whole", *options, case=self.case(case))
                # the last checkpoint lies at 0.4 s: the run folder with its record taken away is one killed after it
                part = self.home / f"{name}-part"
                shutil.copytree(whole, part)
                (part / "run.json").unlink()
                (part / "profile.csv").unlink()
                self.riffle("run", "--resume", part, "--quiet")
                self.assert_same_bits(whole, part)
                self.assertEqual((whole / "snapshots" / "000003.hdf").exists(), True)
                a, b = self.record(whole), self.record(part)
                for key in ("time", "steps", "particles", "errors", "extrema", "ledger", "dt_limiters"):
                    self.assertEqual(a[key], b[key], key)

    def test_a_signal_writes_a_checkpoint_from_which_the_run_ends_with_the_same_bits(self):
        whole, seconds = self.uninterrupted("wet-0.5")
        for how in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=how):
                shutil.rmtree(self.home / "part", ignore_errors=True)
                part = self.interrupted("wet-0.5", how, 0.4 * seconds)
                self.assertIsNotNone(part, "the run was over before it could be interrupted")
                self.assertFalse((part / "run.json").exists(), "an interrupted run has not ended")
                self.assertTrue((part / "checkpoint.h5").exists())
                self.riffle("run", "--resume", part, "--quiet")
                self.assert_same_bits(whole, part)

    def test_killed_at_random_moments_a_run_goes_on_from_its_last_checkpoint(self):
        options = ["--set", "output.checkpoint=0.1"]
        whole, seconds = self.uninterrupted("wet-0.5", *options)
        dice = random.Random(7)
        for k in range(3):
            shutil.rmtree(self.home / "part", ignore_errors=True)
            part = self.interrupted("wet-0.5", signal.SIGKILL, dice.uniform(0.2, 0.9) * seconds, *options)
            if part is None or not (part / "checkpoint.h5").exists():
                continue
            self.riffle("run", "--resume", part, "--quiet")
            self.assert_same_bits(whole, part)

    def test_a_damaged_checkpoint_is_noticed_and_the_one_before_it_is_used(self):
        whole = self.run_case("whole", "--set", "output.checkpoint=0.1")
        part = self.home / "part"
        shutil.copytree(whole, part)
        (part / "run.json").unlink()
        newest = part / "checkpoint.h5"
        newest.write_bytes(newest.read_bytes()[:-100])
        warning = self.riffle("run", "--resume", part, "--quiet").stderr
        self.assertIn("checkpoint", warning)
        self.assert_same_bits(whole, part)


if __name__ == "__main__":
    main()
