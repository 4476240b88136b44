# From the folder of the case: gnuplot system/sensor2.gp
set terminal pngcairo size 1000,560 font "sans,12"
set output "pictures/sensor2.png"
set datafile separator ","
set xlabel "t [s]"
set ylabel "pressure at sensor 2 [kPa]"
set xrange [0.4:1.25]
set yrange [0:6]
set key top right
run = "< grep -v '#' postProcessing/sensor2/0/sensor2.dat | tr -s ' ' ','"
plot "reference/sensor2.csv" using 1:($3/1000):($4/1000) with filledcurves fillcolor rgb "#c8d8e8" title "95 % of the tests", \
     "" using 1:($2/1000) with lines lw 2 lc rgb "#406080" title "their median", \
     run using 1:($2/1000) with lines lw 1.5 lc rgb "#c04020" title "this run"
