#!/usr/bin/env python3
"""Runs the shipped studies and makes docs/results.md of them: docs/pictures/studies.py [PROGRAM [WORD...]]. PROGRAM is `./riffle` of
this tree unless given. With words only those studies are done whose path holds one of them, and the rest of the page stays. Runs are kept in studies/, so that a second call takes seconds and an interrupted one goes on; the times
on the page are the sums of what the runs took, in CPU seconds."""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PICTURES = ROOT / "docs" / "pictures"
HEAD = """# Results

What the shipped studies found: error against cost for the closures of each family of cases, and maps of where they work. Each
picture stands above the command that makes it and the CPU time that its runs took, on {machine}. The page is made by
`docs/pictures/studies.py`; how to read the charts and to write a study of your own is in [comparing.md](comparing.md), and the
figures of the first release against their targets are in [results-foundation.md](results-foundation.md).
"""


def opening(text):
    """The comment that a study begins with, without the command that is in it."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        line = line.lstrip("#").strip()
        if line and not line.startswith("./riffle"):
            lines.append(line)
    return re.sub(":$", ".", " ".join(lines))


def title_of(text):
    return re.search(r'^title = "(.*)"', text, re.M)[1]


def seconds_of(folder):
    records = [json.loads(path.read_text()) for path in folder.glob("runs/*/run.json")]
    return sum(record["cpu_seconds"] for record in records), len(records), records[0]["machine"]["processor"] if records else "?"


def better_by_a_fifth(front):
    kept, last = [], float("inf")
    for line in front.splitlines():
        error = float(line.rsplit(": ", 1)[1].split(" = ")[1].split(",")[0])
        if error <= 0.8 * last:
            kept.append(line + "\n")
            last = error
    return "".join(kept)


def figures(rows):
    """Of a study that judges no error: its numbers at the finest resolution, a line per closure."""
    keys = list(rows[0])
    numbers = [key for key in keys if key.startswith("fronts.") or key == "plateau"]
    finest = {row["closure"]: row for row in rows}  # the last resolution of each
    lines = ["| closure | " + " | ".join(numbers) + " |", "|---" * (len(numbers) + 1) + "|"]
    for closure, row in finest.items():
        shown = [f"{float(row[key]):.4g}" if row[key] not in ("", "nan") else "-" for key in numbers]
        lines.append(f"| {closure} | " + " | ".join(shown) + " |")
    return "\n".join(lines) + "\n"


def compared(folder, name):
    """Chart and front of each case, by the first error."""
    parts = []
    with open(folder / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    error = next((key for key in rows[0] if key.startswith("errors.")), None)
    if error is None:
        return [figures(rows)]
    tables = (folder / "results.md").read_text()
    for case in dict.fromkeys(row["case"] for row in rows):
        chart = f"{case}-{error.removeprefix('errors.')}-cost.svg"
        if not (folder / "charts" / chart).exists():
            continue
        picture = f"{name}-{case}.svg"
        shutil.copy(folder / "charts" / chart, PICTURES / picture)
        title = next(row["case"] for row in rows if row["case"] == case)
        parts.append(f"![{title}: error against cost](pictures/{picture})\n")
        section = tables.split("\n## ")[1 + list(dict.fromkeys(row["case"] for row in rows)).index(case)]
        front = re.search(r"The Pareto front, from the cheapest on:\n\n((?:- .*\n)+)", section)
        if front:
            parts.append(f"What nothing beats in `{case}`, from the cheapest on, where it is better by a fifth at least than the one "
                         f"before (all of them: `results.md` of the study):\n\n{better_by_a_fifth(front[1])}")
    return parts


def mapped(folder, name, said):
    parts = []
    for picture in sorted(folder.glob("*.svg")):
        shutil.copy(picture, PICTURES / f"{name}-{picture.name}")
        parts.append(f"![map of stability: {picture.stem}](pictures/{name}-{picture.name})\n")
    parts.append("\n".join(f"- {line}" for line in said.splitlines() if "points run" in line) + "\n")
    return parts


def kept_sections():
    """Those of the page as it is, by their titles."""
    parts = re.split(r"^(?=## )", (ROOT / "docs" / "results.md").read_text(), flags=re.M)[1:]
    return {part.split("\n", 1)[0].removeprefix("## "): part.rstrip("\n") + "\n" for part in parts}


def main():
    program = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT / "riffle"
    words = sys.argv[2:]
    os.chdir(ROOT)
    page, machine, kept = [], "?", kept_sections()
    for study in sorted(ROOT.glob("cases/*/*.study.toml")):
        text = study.read_text()
        if words and not any(word in str(study.relative_to(ROOT)) for word in words) and title_of(text) in kept:
            page.append("\n" + kept[title_of(text)])
            continue
        command = "stability" if re.search(r"^\[map\]", text, re.M) else "compare"
        folder = Path("studies") / re.search(r'^name = "(.*)"', text, re.M)[1]
        said = subprocess.run([program, command, study.relative_to(ROOT), "--quiet"], check=True, text=True, stdout=subprocess.PIPE).stdout
        cpu, runs, machine = seconds_of(folder)
        name = folder.name
        page += [f"\n## {title_of(text)}\n", opening(text) + "\n"]
        page += mapped(folder, name, said) if command == "stability" else compared(folder, name)
        page.append(f"```\n./riffle {command} {study.relative_to(ROOT)}\n```\n\n{runs} runs, {cpu:.3g} s of CPU time.\n")
    (ROOT / "docs" / "results.md").write_text(HEAD.format(machine=machine) + "\n".join(page))


if __name__ == "__main__":
    main()
