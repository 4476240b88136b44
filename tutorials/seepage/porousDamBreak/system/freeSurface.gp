# Free surface with both coefficients against the experiment: gnuplot system/freeSurface.gp
set terminal pngcairo size 1200,900 font ",11"
set output "pictures/freeSurface.png"
# The row of time t, as lines of x and elevation.
row(folder, t) = sprintf("< awk '/^# x /{for (k = 3; k <= NF; ++k) x[k-2] = $k} !/^#/ && ($1 - %g)^2 < 1e-12 {for (k = 2; k <= NF; ++k) print x[k-1], $k}' %s/postProcessing/freeSurface/*/freeSurface.dat", t, folder)
measured(t) = sprintf("< awk -F, '$1 == \"%.2f\" {print $2, $3}' reference/freeSurface.csv", t)
set xrange [0:0.892]
set yrange [0:0.38]
set xlabel "x [m]"
set ylabel "z [m]"
set object rectangle from 0.30,0 to 0.59,0.37 fillcolor "#e8e0d0" fillstyle solid noborder behind
set multiplot layout 3,2
do for [t in "0.35 0.75 1.15 1.55 1.95"] {
    set title sprintf("t = %s s", t)
    plot measured(t + 0) with points pointtype 6 linecolor "black" title "experiment", \
         row(".", t + 0) with lines linewidth 2 linecolor "#2060c0" title "betaC 2.0", \
         row("betaC1.1", t + 0) with lines linewidth 2 linecolor "#c06020" title "betaC 1.1"
}
unset multiplot
