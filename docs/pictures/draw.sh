#!/usr/bin/env bash
# Draws the pictures of the documentation again: docs/pictures/draw.sh [PROGRAM]. PROGRAM is `./riffle` of this tree unless
# given. Some seconds of CPU time per picture. tutorial.png comes from tests/docs/run_tutorial.sh.
set -euo pipefail
root=$(readlink -f "$(dirname "$0")/../..")
riffle=$(readlink -f "${1:-$root/riffle}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

run() { # name of the result, case, options...
  "$riffle" run "$root/cases/dam-break/$2.toml" --out "$folder/$1" --threads 1 --quiet "${@:3}"
}
for case in dry wet-0.1 wet-0.25 wet-0.5; do
  run "$case" "$case"
  cp "$folder/$case/picture.png" "$root/docs/pictures/$case.png"
done

run quintic wet-0.5 --set plugins.kernel.id=quintic-spline
cd "$folder"
gnuplot <<'END'
set datafile separator comma
set terminal pngcairo size 1400,560 font "sans,14" linewidth 1.5
set output "kernels.png"
set xlabel "x [m]"
set ylabel "depth [m]"
set xrange [35:90]
set grid lc rgb "#e2e2e2"
plot "wet-0.5/profile.csv" using "x":"depth_exact" with lines lw 2 lc rgb "#0072b2" title "exact (stoker)", \
     "wet-0.5/profile.csv" using "x":"depth" every 12 with points pt 7 ps 0.6 lc rgb "#d55e00" title "cubic-spline, l = 2 dx", \
     "quintic/profile.csv" using "x":"depth" every 12 with points pt 6 ps 0.9 lc rgb "#009e73" title "quintic-spline, l = 2 dx"
END
cp kernels.png "$root/docs/pictures/kernels.png"
