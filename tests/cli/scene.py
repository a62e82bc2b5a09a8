"""What the tests of the program share: running it in a folder of its own, on short dam breaks."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = (Path(a).resolve() for a in sys.argv[1:3]) if len(sys.argv) > 2 else (None, None)
SHORT = ["--set", "initial.particles.count=400", "--set", "time.end=0.6", "--set", "output.picture=false"]


class Scene(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="riffle-cli-")
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)

    @staticmethod
    def case(name="wet-0.5"):
        return str(SOURCE / "cases" / "dam-break" / f"{name}.toml")

    def riffle(self, *arguments, code=0):
        """Runs the program and returns what it printed; fails when the exit code is another than `code`."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.home, capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def run_case(self, out, *more, case=None, code=0):
        self.riffle("run", case or self.case(), "--quiet", "--out", out, *SHORT, *more, code=code)
        return self.home / out

    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.home, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    @staticmethod
    def record(folder):
        return json.loads((Path(folder) / "run.json").read_text())

    def assert_same_bits(self, a, b):
        self.assertEqual((a / "profile.csv").read_bytes(), (b / "profile.csv").read_bytes())


def main():
    unittest.main(argv=[sys.argv[0]], verbosity=2)
