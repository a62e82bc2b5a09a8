#!/usr/bin/env python3
"""Every link in the Markdown pages of this tree leads somewhere, and every path of the tree that a page names exists.

  links.py ROOT

Checked: [text](file), [text](file#heading), [text](#heading), pictures, and paths in backquotes that begin with a folder
of the tree, such as `host/schedule/plan.cpp`, `cases/*/*.toml` or `tests/docs/{links,generate}.py`. Addresses on the web
are left alone.
"""

import os
import pathlib
import re
import sys

SKIPPED = {"build", "runs", ".git", "node_modules"}
OURS = re.compile(r"(host|sdk|plugins|cases|tests|docs|\.ci)/[\w.*{},/-]+")


def pages(root):
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in SKIPPED)
        yield from (pathlib.Path(folder) / f for f in sorted(files) if f.endswith(".md"))


def prose(text):
    """Lines outside fenced code, with their numbers."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r" {0,3}(```+|~~~+)", line)
        if mark and fence is None:
            fence = mark[1]
        elif mark and mark[1].startswith(fence):
            fence = None
        elif fence is None:
            yield number, line


def anchors(page):
    """As GitHub makes them: lower case, spaces to hyphens, all but letters, digits, - and _ gone, repeats numbered."""
    seen, found = {}, set()
    for _, line in prose(page.read_text()):
        heading = re.match(r" {0,3}#{1,6} +(.*?) *#* *$", line)
        if not heading:
            continue
        shown = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).replace("`", "")
        slug = re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")
        found.add(slug + (f"-{seen[slug]}" if slug in seen else ""))
        seen[slug] = seen.get(slug, 0) + 1
    return found


def expanded(path):
    """a/{b,c}.d as a/b.d and a/c.d."""
    braces = re.search(r"\{([^{}]*)\}", path)
    if not braces:
        return [path]
    return [q for word in braces[1].split(",") for q in expanded(path[: braces.start()] + word + path[braces.end() :])]


def broken(root, page):
    for number, line in prose(page.read_text()):
        where = f"{page.relative_to(root)}:{number}"
        for code in re.findall(r"`([^`]+)`", line):
            if not OURS.fullmatch(code):
                continue
            for path in expanded(code):
                if not any(root.glob(path.rstrip("/"))):
                    yield f"{where}: there is no {path}"
        for target in re.findall(r"\]\(([^()\s]+(?:\([^()\s]*\))?)(?: \"[^\"]*\")?\)", re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z]+:", target):
                continue
            file, _, heading = target.partition("#")
            goal = page if not file else (page.parent / file)
            if not goal.exists():
                yield f"{where}: the link {target} leads nowhere"
            elif heading and heading not in anchors(goal):
                yield f"{where}: {file or page.name} has no heading #{heading}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(pages(root))
    lines = [line for page in found for line in broken(root, page)]
    print("\n".join(lines))
    if lines or not found:
        sys.exit(f"{len(lines)} broken links in {len(found)} pages")


if __name__ == "__main__":
    main()
