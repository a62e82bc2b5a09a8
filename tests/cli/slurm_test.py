"""Job arrays of a real Slurm: one node, this machine, started here and stopped at the end. Skipped, with the reason, where
its packages are missing, without root, or where another Slurm runs already."""
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from scene import Scene, main

STUDY = """
[study]
name = "small"
cases = "{case}"
threads = [1, 2]
pictures = false
time_limit = "30 s"
[set]
time.end = 0.5
[resolution]
initial.particles.count = [100, 200]
[closures."no viscosity"]
plugins.viscosity.id = "none"
[closures."no such density"]
initial.depth = "x < 50 ? 10 : sqrt(-x)"
"""


class OneNode:
    """Its configuration and state live in a folder of their own, so that an installed Slurm is left as it is."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="riffle-slurm-"))
        self.folder.chmod(0o755)
        self.running = []

    def start(self):
        host, here = socket.gethostname().split(".")[0], self.folder
        for name in ("state", "spool", "munge"):
            (here / name).mkdir()
        shutil.chown(here / "munge", "munge", "munge")
        key = here / "munge" / "key"
        key.write_bytes(os.urandom(1024))
        shutil.chown(key, "munge", "munge")
        key.chmod(0o400)
        self.socket = here / "munge" / "socket"
        (here / "slurm.conf").write_text(f"""ClusterName=riffle-test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket={self.socket}
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SlurmUser=root
StateSaveLocation={here}/state
SlurmdSpoolDir={here}/spool
SlurmctldPidFile={here}/slurmctld.pid
SlurmdPidFile={here}/slurmd.pid
SlurmctldLogFile={here}/slurmctld.log
SlurmdLogFile={here}/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")
        os.environ["SLURM_CONF"] = str(here / "slurm.conf")
        self.launch("runuser", "-u", "munge", "--", "munged", "--foreground", f"--key-file={key}", f"--socket={self.socket}",
                    f"--pid-file={here}/munge/pid", f"--log-file={here}/munge/log", f"--seed-file={here}/munge/seed")
        for _ in range(100):
            if self.socket.exists():
                break
            time.sleep(0.1)
        self.launch("slurmctld", "-D", "-f", here / "slurm.conf")
        self.launch("slurmd", "-D", "-f", here / "slurm.conf")
        for _ in range(300):
            state = subprocess.run(["sinfo", "-h", "-o", "%t"], capture_output=True, text=True).stdout.strip()
            if state == "idle":
                return
            time.sleep(0.2)
        raise RuntimeError("Slurm did not come up:\n" + "\n".join(
            (here / f"{name}.log").read_text()[-2000:] for name in ("slurmctld", "slurmd") if (here / f"{name}.log").exists()))

    def launch(self, *command):
        self.running.append(subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))

    def stop(self):
        for process in reversed(self.running):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Slurm(Scene):
    def test_a_study_submits_arrays_waits_and_collects(self):
        (self.home / "small.toml").write_text(STUDY.format(case=self.case()))
        said = self.riffle("compare", "small.toml", "--launcher", "slurm", "--wait")
        self.assertRegex(said.stderr, r"8 runs in 2 job arrays of Slurm: \d+, \d+")
        self.assertIn("8 combinations", said.stdout)
        self.assertEqual(len(list(self.home.glob("studies/small/runs/*/run.json"))) + len(list(self.home.glob("studies/small/ended/*.json"))), 8)
        self.assertIn("4 finished", said.stdout)
        # what has ended is not submitted again
        again = self.riffle("compare", "small.toml", "--launcher", "slurm", "--wait")
        self.assertNotIn("job arrays", again.stderr)

    def test_a_refusal_of_sbatch_is_one_line(self):
        (self.home / "small.toml").write_text(STUDY.format(case=self.case()))
        said = self.riffle("compare", "small.toml", "--launcher", "slurm", "--sbatch=--partition=nowhere", code=2)
        self.assertIn("sbatch took no job: ", said.stderr)
        self.assertIn("partition", said.stderr)


def why_not():
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch", "sinfo", "runuser") if shutil.which(name) is None]
    if missing:
        return f"no {', '.join(missing)} on PATH (packages slurm-wlm and munge)"
    return "starting Slurm takes root" if os.geteuid() != 0 else ""


if __name__ == "__main__":
    os.environ["PATH"] += ":/usr/sbin"
    reason = why_not()
    if reason:
        print(f"[skipped] {reason}")
        sys.exit(77)
    node = OneNode()
    try:
        node.start()
        main()
    finally:
        node.stop()
