#!/usr/bin/env bash
# clang-tidy over every source of a build tree that was configured: tidy.sh SOURCE_TREE BUILD_TREE [PATTERN].
# PATTERN narrows it to files whose path matches, e.g. host/neighbours. Minutes long, therefore no part of `./riffle test`.
set -u
root=$(readlink -f "$1")
build=$(readlink -f "$2")
tidy=$(command -v clang-tidy-14 || command -v clang-tidy)
if [ -z "$tidy" ]; then
  echo "[skipped] clang-tidy is not installed"
  exit 77
fi
cd "$root" || exit 1
# Each file once: a test may compile one source into several programs.
grep -oE '"file": "[^"]+"' "$build/compile_commands.json" | cut -d'"' -f4 | grep -E "^$root/.*${3:-}" |
  grep -v "^$build/" | sort -u |
  xargs -r -P "$(nproc)" -n 1 "$tidy" --quiet -p "$build" --warnings-as-errors='*' 2>/dev/null
