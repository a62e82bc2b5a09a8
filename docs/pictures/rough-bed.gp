# Twelve flows over rough beds: velocities and stresses of particles and column, from the means.csv that
# cases/rough-bed/profiles.py leaves in each run:  cd RUNS && gnuplot ROOT/docs/pictures/rough-bed.gp
# where RUNS holds one folder per case, named after it (S004H40, ...).
set datafile separator comma
cases = "S004H40 S004H50 S004H70 S004H90 S004H100 S003H50 S003H60 S003H70 S003H80 S002H60 S002H70 S002H80"
set terminal pngcairo size 1500,1050 font "sans,11" linewidth 1.4
set grid lc rgb "#e2e2e2"
set tics front
set key samplen 1.5
do for [what in "velocity stress"] {
  set output sprintf("rough-bed-%s.png", what)
  set multiplot layout 3,4 margins 0.05,0.985,0.06,0.96 spacing 0.045,0.075
  do for [name in cases] {
    set title name offset 0,-0.6
    set ylabel (name eq "S004H40" || name eq "S004H100" || name eq "S003H80") ? "z [mm]" : ""
    last = name[1:4] eq "S002" || name eq "S003H80"
    file = name."/means.csv"
    if (what eq "velocity") {
      set key bottom right
      set xlabel last ? "u [m/s]" : ""
      set xrange [0:*]
      plot file using "u_column":(1e3*column("z")) with lines lc rgb "#0072b2" title "column", \
           file using "u":(1e3*column("z")) with points pt 7 ps 0.6 lc rgb "#d55e00" title "particles"
    } else {
      set key top right
      set xlabel last ? "stress [Pa]" : ""
      set xrange [*:*]
      plot file using "tau_column":(1e3*column("z")) with lines lc rgb "#0072b2" title "column", \
           file using "tau":(1e3*column("z")) with points pt 7 ps 0.6 lc rgb "#d55e00" title "modelled", \
           file using "virial":(1e3*column("z")) with points pt 6 ps 0.6 lc rgb "#1a1a1a" title "of the lattice"
    }
  }
  unset multiplot
}
