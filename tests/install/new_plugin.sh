#!/usr/bin/env bash
# A newcomer's first minutes: new_plugin.sh PREFIX FOLDER KIND COMPILER. With nothing but the installed program, make a
# project of this kind, build it, check it and run its case; nothing may be edited in between.
set -euo pipefail
prefix=$1 folder=$2 kind=$3 compiler=$4
riffle=$prefix/bin/riffle
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

"$riffle" new "$kind" "my-$kind"
cmake -S "my-$kind" -B "my-$kind/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS=-Werror
cmake --build "my-$kind/build"
"$riffle" check "my-$kind/my-$kind.so"
"$riffle" describe "$kind/my-$kind" --plugin-path "my-$kind" | grep -q "my-$kind"
"$riffle" run "my-$kind/case.toml" --threads 1 --quiet --out run
grep -q '"status": "finished"' run/run.json
grep -q "my-$kind" run/run.json
