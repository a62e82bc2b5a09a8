#!/usr/bin/env bash
# A file is about one thing, and then 400 lines are plenty.
set -u
cd "$1" || exit 1
find host plugins sdk tests -type f \( -name '*.[ch]' -o -name '*.[ch]pp' -o -name '*.sh' -o -name '*.py' -o -name CMakeLists.txt \) \
  -exec wc -l {} + | awk '
    $2 == "total" { next }
    $1 > 400 { print $2 " has " $1 " lines"; broken = 1 }
    END { exit broken }'
