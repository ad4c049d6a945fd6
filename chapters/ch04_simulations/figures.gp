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
limit(k) = k == 1 ? limit1_mean : k == 2 ? limit2_mean : k == 3 ? limit3_mean : limit4_mean
plot for [k = 1:4] file('ends') skip 1 using 3:(way('backward Euler', k, 4)) with linespoints lt k title title_of(k), \
     for [k = 1:4] file('ends') skip 1 using 3:(way('Verlet', k, 4)) with linespoints lt k dt (4,3) notitle, \
     for [k = 1:4] limit(k) with lines lt k lw 0.9 dt 1 notitle, \
     NaN with linespoints lt 7 dt 1 pt 7 title 'Euler', NaN with linespoints lt 7 dt (4,3) title 'Verlet', \
     NaN with lines lt 7 lw 0.9 dt 1 title 'located'
unset logscale
set xtics autofreq
unset offsets

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
