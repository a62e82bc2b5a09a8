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

# Open channel and waves: one run each, its own picture
for case in boussinesq/r0.5 undular-bore/r0.7 step/steady hump/supercritical hump/transcritical hump/transcritical-shock contraction/subcritical \
  contraction/transcritical parshall/flume; do
  name=${case//\//-}
  "$riffle" run "$root/cases/$case.toml" --out "$folder/$name" --threads 1 --quiet
  cp "$folder/$name/picture.png" "$root/docs/pictures/$name.png"
done

# The jump of test 4 with what was measured
"$riffle" run "$root/cases/hydraulic-jump/fr4.23.toml" --out "$folder/hydraulic-jump-fr4.23" --threads 1 --quiet
cp "$root/cases/hydraulic-jump/test4-profile.csv" .
gnuplot <<'END'
set datafile separator comma
set terminal pngcairo size 1400,560 font "sans,14" linewidth 1.5
set output "jump-fr4.23.png"
set xlabel "x [m]"
set ylabel "depth [m]"
set xrange [0.3:4.5]
set yrange [0:0.26]
set key bottom right
set grid lc rgb "#e2e2e2"
plot "hydraulic-jump-fr4.23/profile.csv" using "x":"depth_exact" with lines lw 2 lc rgb "#0072b2" title "exact (steady-flow)", \
     "hydraulic-jump-fr4.23/profile.csv" using "x":"depth" with points pt 7 ps 0.8 lc rgb "#d55e00" title "computed", \
     "test4-profile.csv" using "x_m":"h_m" with points pt 6 ps 1.6 lw 1.5 lc rgb "#1a1a1a" title "measured (Gharangik and Chaudhry 1991, test 4)"
END
cp jump-fr4.23.png "$root/docs/pictures/jump-fr4.23.png"

# Water in pores
"$riffle" run "$root/cases/porous-dam/crushed-rock.toml" --out "$folder/dam22" --threads 1 --quiet
gnuplot "$root/docs/pictures/porous-dam.gp"
cp porous-dam-crushed-rock.png "$root/docs/pictures/porous-dam-crushed-rock.png"
for case in seepage/block breakwater/porous; do
  name=${case//\//-}
  "$riffle" run "$root/cases/$case.toml" --out "$folder/$name" --threads 1 --quiet
  cp "$folder/$name/picture.png" "$root/docs/pictures/$name.png"
done
