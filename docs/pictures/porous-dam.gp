set datafile separator comma
set terminal pngcairo size 1400,760 font "sans,14" linewidth 1.5
set output "porous-dam-crushed-rock.png"
set multiplot layout 2,2 margins 0.06,0.98,0.07,0.93 spacing 0.06,0.13
set xrange [0:0.892]
set yrange [0:0.26]
set grid lc rgb "#e2e2e2"
set object 1 rectangle from 0.30,0 to 0.59,0.26 fc rgb "#efe9e0" fs solid noborder behind
do for [t in "0.4 0.8 1.4 2.2"] {
  set title sprintf("t = %s s", t)
  plot "dam22/surface.csv" using ($1 == t + 0 ? $2 : NaN):4 with points pt 7 ps 0.8 lc rgb "#d55e00" title "computed", \
       "" using ($1 == t + 0 ? $2 : NaN):3 with points pt 6 ps 1.2 lw 1.5 lc rgb "#1a1a1a" title "measured (Liu et al. 1999)"
}
unset multiplot
