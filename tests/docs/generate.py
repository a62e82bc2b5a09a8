#!/usr/bin/env python3
"""Makes the pages that are drawn from the code: docs/fields.md from sdk/include/riffle/fields.h, and docs/plugins.md
from what `riffle describe` says of every shipped plugin.

  generate.py ROOT PROGRAM           writes both pages
  generate.py ROOT PROGRAM --check   writes nothing; fails, with the differences, when a committed page is another
"""

import difflib
import os
import pathlib
import re
import subprocess
import sys

SHAPES = {"SCALAR": "scalar", "VECTOR": "vector", "SYMMETRIC": "symmetric tensor", "TENSOR": "tensor"}
FLAGS = {"ACCUMULATES": "a sum: several passes may add to it", "NOT_NEGATIVE": "never below 0"}

FIELDS_HEAD = """# The dictionary of fields

<!-- Made by tests/docs/generate.py from sdk/include/riffle/fields.h; edit that file. -->

Plugins meet in fields: one writes `depth`, another reads it, and neither knows of the other. A name in this dictionary has
one shape, one unit, one meaning and one sign everywhere. In C++ it is `riffle::fields::depth` (`<riffle/sdk.hpp>`), in C
the same five facts in a `riffle_field` (`<riffle/abi.h>`).

A plugin may also use names of its own; two plugins that share such a name must agree on its shape and unit, which the
host checks before a run. [tutorial-first-closure.md](tutorial-first-closure.md) shows fields at work, and
`riffle explain CASE` which of them a case has, who reads them, and what they cost.

Units are products of powers of SI base units: `m2.s-1` is m²/s. An exponent `d` is the number of dimensions: `md` is a
length, an area or a volume, `m-d` the inverse of one. Velocities are intrinsic (pore) velocities; pressures are relative
to the atmosphere and positive in compression.

The last column names the shipped plugins that write the field. Initial fields come from `[initial]` of the manifest;
`position` and `cell_measure` the host sets when it places the particles. A field without a writer is open: a pass that
reads it needs a plugin which provides it.
"""

PAIR_HEAD = """## Fields of pairs

One value per pair (i, j), alive while one block of pairs is worked on. The host forms geometry, the kernel plugin its six
outputs; kernel outputs are asked for with the smoothing length of i, of j or of their mean (`at_i`, `at_j`, `mean`).
"""

PLUGINS_HEAD = """# The shipped plugins

<!-- Made by tests/docs/generate.py from `riffle describe`; edit the plugins' own tables. -->

What each plugin says of itself, as `riffle describe ID` prints it. Fields are explained in [fields.md](fields.md), the
manifest in [manifest.md](manifest.md). A parameter stands in the plugin's table of the manifest, in SI or with a unit:
`alpha = 2.0`, `dam_position = "3.37 m"`. A default such as "`fluid.gravity`" is that quantity of the same manifest.
"""


def cell(text):
    return text.replace("|", "\\|")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(cell(c) for c in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def dictionary(root):
    """The entries of fields.h: name, shape, flags, unit, meaning; those of particles and those of pairs."""
    text = (root / "sdk/include/riffle/fields.h").read_text().replace("\\\n", " ")
    lists = {}
    for name, body in re.findall(r"#define (RIFFLE_FIELDS|RIFFLE_PAIR_FIELDS)\(X\)(.*)", text):
        entry = r'X\((\w+), RIFFLE_(\w+), ([^,"]+), "([^"]*)",\s*((?:"[^"]*"\s*)+)\)'
        found = [
            (n, SHAPES[s], flags, unit, "".join(re.findall(r'"([^"]*)"', meaning)))
            for n, s, flags, unit, meaning in re.findall(entry, body)
        ]
        if len(found) != body.count("X("):
            sys.exit(f"generate.py: {body.count('X(')} entries in {name}, of which {len(found)} can be read")
        lists[name] = found
    return lists["RIFFLE_FIELDS"], lists["RIFFLE_PAIR_FIELDS"]


def say(program, *arguments):
    environment = {k: v for k, v in os.environ.items() if k != "RIFFLE_PLUGIN_PATH"}
    done = subprocess.run([program, *arguments], capture_output=True, text=True, env=environment, cwd="/")
    if done.returncode != 0 or done.stderr:
        sys.exit(f"generate.py: {program} {' '.join(arguments)} says: {done.stderr or done.stdout}")
    return done.stdout


def plugin_names(program):
    kind, names = "", []
    for line in say(program, "list").splitlines():
        if line.startswith("  "):
            names.append((kind, line.split()[0]))
        elif line:
            kind = line
    return names


def read_description(text):
    """`riffle describe` as a dictionary; stops at a line that it does not know."""
    d = {"facts": {}, "parameters": [], "initial": [], "gives": [], "passes": []}
    lines = iter(text.splitlines())
    head = next(lines)
    d["version"], d["summary"] = re.match(r"\S+ \S+ (\S+): (.*)", head).groups()
    for line in lines:
        if not line:
            continue
        if match := re.fullmatch(r"  (source|leaves out|dimensions|library|build) +(.*)", line):
            d["facts"][match[1]] = match[2]
        elif match := re.fullmatch(r"parameter (\S+) \[(\S+)\], (?:default )?(required|from \S+|\".*?\"|\S+), (.*)", line):
            d["parameters"].append([*match.groups(), next(lines).strip()])
        elif match := re.fullmatch(r"initial field (\S+) \[(\S+)\]", line):
            next(lines)  # the meaning, which fields.md has
            d["initial"].append(match.groups())
        elif match := re.fullmatch(r"gives (\S+) \[(\S+)\]", line):
            d["gives"].append(match.groups())
        elif match := re.fullmatch(r"pass (.*) \((\w+)(, once at t = 0)?\)", line):
            name = match[1] + (" (once, at t = 0)" if match[3] else "")
            d["passes"].append({"name": name, "type": match[2], "when": "", "reads": [], "writes": []})
        elif match := re.fullmatch(r"  when +(.*)", line):
            d["passes"][-1]["when"] = match[1]
        elif match := re.fullmatch(r"  (reads|writes) +(\S+)(.*?) ?\[\S+\](.*)", line):
            d["passes"][-1][match[1]].append((match[2], match[3].strip() + match[4]))
        else:
            sys.exit(f"generate.py: `riffle describe` has a line that this script does not know: {line}")
    return d


def default_text(text):
    if text.startswith("from "):
        return f"`{text[5:]}`"
    return "none, must be given" if text == "required" else text.strip('"')


def plugin_page(descriptions):
    page, last = [PLUGINS_HEAD], ""
    for (kind, name), d in descriptions.items():
        if kind != last:
            page.append(f"## {kind}\n")
        last = kind
        facts = d["facts"]
        page.append(f"### {name}\n\n{d['summary']}. Version {d['version']}, dimensions {facts['dimensions']}.\n")
        notes = [f"- Source: {facts['source']}."] if "source" in facts else []
        notes += [f"- Limits: {facts['leaves out']}."] if "leaves out" in facts else []
        notes += ["- Initial fields: " + ", ".join(f"`{f}` [{u}]" for f, u in d["initial"]) + "."] if d["initial"] else []
        notes += ["- Gives: " + ", ".join(f"`{f}` [{u}]" for f, u in d["gives"]) + "."] if d["gives"] else []
        if notes:
            page.append("\n".join(notes) + "\n")
        if d["parameters"]:
            rows = [
                [f"`{n}`", "" if u == "1" else u, default_text(default), limits, doc]
                for n, u, default, limits, doc in d["parameters"]
            ]
            page.append(table(["parameter", "unit", "default", "values", "meaning"], rows))
        if d["passes"]:
            listed = lambda fields: ", ".join(f"`{f}`" + (f" ({how.strip(', ()')})" if how else "") for f, how in fields)
            rows = [
                [p["name"] + (f", when `{p['when']}`" if p["when"] else ""), p["type"], listed(p["reads"]), listed(p["writes"])]
                for p in d["passes"]
            ]
            page.append(table(["pass", "type", "reads", "writes"], rows))
    return "\n".join(page)


def fields_of_the_host(root):
    """What the host's own passes write, from their declarations."""
    for file in ("host/terrain/terrain_fields.cpp", "host/schedule/host_fields.cpp"):
        for declared in re.findall(r"writes\[\] = \{(.*?)\};", (root / file).read_text(), re.S):
            yield from re.findall(r"f::(\w+)", declared)


def fields_page(root, descriptions):
    particles, pairs = dictionary(root)
    writers = {field: ["the host"] for field in fields_of_the_host(root)}
    for (_, name), d in descriptions.items():
        for p in d["passes"]:
            for field, _ in p["writes"]:
                if name not in writers.setdefault(field, []):
                    writers[field].append(name)

    def row(name, shape, flags, unit, meaning):
        notes = [text for flag, text in FLAGS.items() if flag in flags]
        shown = meaning + (f" ({'; '.join(notes)})" if notes else "")
        return [f"`{name}`", shape, unit, shown, ", ".join(writers.get(name, []))]

    head = ["field", "shape", "unit", "meaning and sign", "written by"]
    return "\n".join(
        [FIELDS_HEAD, "## Fields of particles\n", table(head, [row(*f) for f in particles]), PAIR_HEAD]
        + [table(head, [row(*f) for f in pairs])]
    )


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["--check"]):
        sys.exit(__doc__)
    root, program = pathlib.Path(sys.argv[1]).resolve(), str(pathlib.Path(sys.argv[2]).resolve())
    names = plugin_names(program)
    descriptions = {(kind, name): read_description(say(program, "describe", f"{kind}/{name}")) for kind, name in names}
    pages = {"docs/fields.md": fields_page(root, descriptions), "docs/plugins.md": plugin_page(descriptions)}
    old = 0
    for path, text in pages.items():
        if sys.argv[3:]:
            have = (root / path).read_text() if (root / path).exists() else ""
            difference = list(difflib.unified_diff(have.splitlines(), text.splitlines(), path, "made anew", lineterm=""))
            if difference:
                print("\n".join(difference[:60]))
                old += 1
        else:
            (root / path).write_text(text)
    if old:
        sys.exit(f"{old} of the pages are out of date: run tests/docs/generate.py ROOT PROGRAM and commit what it writes")


if __name__ == "__main__":
    main()
