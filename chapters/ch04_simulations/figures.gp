# Figures of chapter 4, from what ch04_simulations wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
case(k) = word('(1) (2) (3) (4)', k)
of(k, c) = strstrt(strcol(1), case(k)) == 1 ? column(c) : NaN
title_of(k) = word('none weak medium strong', k)

set output 'ch04_proportions.svg'
set xlabel 'time [s]'
set ylabel 'share of the kinetic energy'
set yrange [0:1]
set key outside top center horizontal maxcols 4
set label 1 'bulk' at graph 0.03, 0.94
set label 2 'relative' at graph 0.03, 0.05
plot for [k = 1:4] file('energies') skip 1 using 2:(of(k, 3)) with lines lt k title title_of(k), \
     for [k = 1:4] file('energies') skip 1 using 2:(of(k, 4)) with lines lt k dt (6,3) notitle
unset label

set output 'ch04_total.svg'
set ylabel 'kinetic energy per mass [J/kg]'
set autoscale y
plot for [k = 1:4] file('energies') skip 1 using 2:(of(k, 5)) with lines lt k title title_of(k)

set output 'ch04_steps.svg'
set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xlabel 'limit of the step [s]'
set ylabel 'relative energy at the end [J/kg]'
set logscale x
set format x '%g'
set xtics add (0.002, 0.005)
set xrange [*:*] noextend
set offsets graph 0.02, graph 0.06, graph 0.05, graph 0.05
way(name, k, c) = strcol(2) eq name ? of(k, c) : NaN
do for [k = 1:4] { stats file('ends') skip 1 using (way('located Gauss', k, 4)) name sprintf('limit%d', k) nooutput }
stats file('ends') skip 1 using (way('hard spheres', 1, 4)) name 'exact' nooutput
limit(k) = k == 1 ? limit1_mean : k == 2 ? limit2_mean : k == 3 ? limit3_mean : limit4_mean
plot exact_mean with lines lc rgb '#b00072b2' lw 7 dt 1 title 'exact', \
     for [k = 1:4] file('ends') skip 1 using 3:(way('backward Euler', k, 4)) with linespoints lt k title title_of(k), \
     for [k = 1:4] file('ends') skip 1 using 3:(way('Verlet', k, 4)) with linespoints lt k dt (4,3) notitle, \
     for [k = 1:4] limit(k) with lines lt k lw 0.9 dt 1 notitle, \
     NaN with linespoints lt 7 dt 1 pt 7 title 'Euler', NaN with linespoints lt 7 dt (4,3) title 'Verlet', \
     NaN with lines lt 7 lw 0.9 dt 1 title 'located'
unset logscale
set xtics autofreq
unset offsets

set output 'ch04_speeds.svg'
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xlabel 'speed / (T/m)^{1/2}'
set ylabel 'density'
set xrange [0:6]
set yrange [0:*]
set key inside top right
plot sqrt(2/pi)*exp(-x*x/2) with lines lt 1 lw 1.4 notitle, x/2*exp(-x*x/4) with lines lt 2 lw 1.4 notitle, \
     file('speeds') skip 1 using 1:2 with points lt 1 title 'components of velocities', \
     '' skip 1 using 1:3 with points lt 2 title 'normal speeds at impact'

set output 'ch04_haff.svg'
set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
gas(e, c) = column(1) == e ? column(c) : NaN
stats file('haff') skip 1 using 1 name 'least' nooutput
stats file('haff') skip 1 using 3 name 'last' nooutput
elastic(k) = word('0.95 0.9 0.8', k) + 0
set multiplot layout 2,1
set lmargin 9
set logscale xy
set xrange [0.1:last_max*1.3]
set autoscale y
set xlabel 'time / τ'
set ylabel 'T / T_0'
set format y '10^{%L}'
set key bottom left
plot 1/(1+x)**2 with lines lt 7 lw 2.5 dt 1 notitle, \
     for [k = 1:3] file('haff') skip 1 using (gas(elastic(k), 3)):(gas(elastic(k), 4)) with points lt k title sprintf('e = %g', elastic(k)), \
     file('haff') skip 1 using (gas(least_min, 3)):(gas(least_min, 4)) with points lt 4 title sprintf('e = %g', least_min)
unset logscale
set format '%g'
set xrange [0:*]
set yrange [*:*]
set ytics 0.2
set xlabel 'impacts of a sphere by theory, c'
set ylabel 'T over Haff'
unset key
plot for [k = 1:3] file('haff') skip 1 using (gas(elastic(k), 2)):(gas(elastic(k), 5)) with linespoints lt k, \
     file('haff') skip 1 using (gas(least_min, 2)):(gas(least_min, 5)) with linespoints lt 4, \
     1 with lines lt 7 dt 1 notitle
unset multiplot
set lmargin -1
set ytics autofreq

# Spheres in their true size about the centre of the cloud, those in front drawn last.
unset border
unset tics
unset grid
unset xlabel
unset ylabel
unset key
set size ratio -1
set cblabel 'speed about the centre [m/s]'
set cbtics format '%g'
set style fill solid 1.0 border rgb 'black'
stats file('places') skip 1 using 1 name 'moment' nooutput
stats file('places') skip 1 using 8 name 'speed' nooutput
set cbrange [0:speed_max]
set xrange [-0.75:0.75]
set yrange [-0.75:0.75]
behind_first = "< tail -n +2 '".file('places')."' | sort -t, -k1,1g -k4,4g"
at(t, c) = abs(column(1) - t) < 1e-9*moment_max ? column(c) : NaN

set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch04_start.svg'
plot behind_first using (at(0, 2)):3:5:8 with circles lc palette lw 0.6, \
     behind_first using (at(0, 2)):3:(0.05*$6):(0.05*$7) with vectors nohead lc rgb 'black' lw 1.2

set terminal gif animate delay 8 loop 0 size 480,440 font 'sans-serif,12' background '#ffffff'
set output 'ch04_film.gif'
do for [k = 0:40] {
  t = k*moment_max/40.0
  set label 1 sprintf('%.2f s', t) at -0.72, 0.7
  plot behind_first using (at(t, 2)):3:5:8 with circles lc palette lw 0.6
}
unset label

# A slice through the gas, sorted by height.
set output 'ch04_clusters.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set autoscale
stats file('clusters') skip 1 using 1 name 'edge' nooutput
set style fill solid 1.0 noborder
set palette defined (-1 '#0072b2', 0 '#c8c8c8', 1 '#d55e00')
set cbrange [-2:2]
set cblabel 'velocity / (T/m)^{1/2}'
set cbtics 1
set xrange [0:edge_max]
set yrange [0:edge_max]
below_first = "< tail -n +2 '".file('clusters')."' | sort -t, -k3,3g"
plot below_first using 1:2:(0.5):4 with circles lc palette
