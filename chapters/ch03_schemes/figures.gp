# Figures of chapter 3, from what ch03_schemes wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'

set output 'ch03_stability.svg'
set xlabel 'c Δt/m'
set ylabel 'factor of one step'
set xrange [0:2.5]
set yrange [-1.6:1.2]
set samples 200
set object 1 rectangle from 0, -1 to 2.5, 1 behind fc rgb '#808080' fs transparent solid 0.12 noborder
set label 1 'no growth' at 2.45, 0.88 right
set key bottom left
plot file('factors') skip 1 using 1:2 with linespoints lt 2 title 'forward Euler', \
     file('factors') skip 1 using 1:7 with linespoints lt 3 pt 8 ps 1.2 dt (6,4) title 'backward Euler, mixed sweeps', \
     file('factors') skip 1 using 1:3 with linespoints lt 1 lw 3 title 'backward Euler, plain sweeps', \
     exp(-x) with lines lt 7 title 'exact', \
     0 with lines lt 7 lw 0.6 dt 1 notitle
unset object
unset label

set xrange [-4:3]
set yrange [-3.5:3.5]
# Contours need a blank line between the columns of the grid.
grid = "< awk -F, 'NR > 1 { if (NR > 2 && $1 != last) print \"\"; last = $1; print }' ".file('regions')
set contour base
unset surface
set cntrparam levels discrete 1
do for [c = 3:8] {
  set table sprintf('contour_%d.dat', c)
  splot grid using 1:2:c
  unset table
}
unset contour
set surface
set datafile separator whitespace
set terminal svg size 640,390 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_regions.svg'
set multiplot layout 1,2 margins 0.11,0.97,0.2,0.87 spacing 0.12
set size ratio -1
set xlabel 'Re z'
set ylabel 'Im z'
set xtics 1
set ytics 1
unset key
contour(c) = sprintf('contour_%d.dat', c)
set title 'one step: growth'
set label 1 'forward' at -1, 0.25 center textcolor lt 2
set label 2 'Euler' at -1, -0.25 center textcolor lt 2
set label 3 'φ = 1,' at 1, 0.25 center textcolor lt 1
set label 4 'outside' at 1, -0.25 center textcolor lt 1
set label 5 'Runge-Kutta' at -3.8, 2.6 textcolor lt 5
set label 6 'φ = 1/2, left' at 0.3, 3.2 textcolor lt 3
plot contour(3) using 1:2 with lines lt 2, contour(4) using 1:2 with lines lt 5, \
     contour(5) using 1:2 with lines lt 1, contour(6) using 1:2 with lines lt 3
unset label
set title 'one sweep: contraction'
set label 1 'φ = 1' at 0.5, 0 center textcolor lt 1
set label 2 'φ = 1/2' at 1.6, 1.7 textcolor lt 3
# Usable is what contracts and does not grow: of φ = 1/2 the left half of its disc, of φ = 1 its disc without the other.
plot contour(8) using ($1 < 0 ? $1 : 0):2 with filledcurves closed fc rgb '#009e73' fs transparent solid 0.15, \
     contour(7) using ($1 < 0.5 ? $1 : 1 - $1):2 with filledcurves closed fc rgb '#0072b2' fs transparent solid 0.3, \
     contour(8) using 1:2 with lines lt 3, contour(7) using 1:2 with lines lt 1, \
     contour(3) using 1:2 with lines lt 2 lw 1.2 dt (4,4), contour(4) using 1:2 with lines lt 5 lw 1.2 dt (4,4)
unset multiplot
unset label
set datafile separator comma
set size noratio
unset title

set terminal svg size 640,360 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_histories.svg'
set multiplot layout 1,3 margins 0.13,0.96,0.23,0.78 spacing 0.04
set xlabel 'contractions K'
set xrange [0:20]
set xtics 10
set logscale y
set yrange [1e-16:1e4]
set ytics 1e4
set format y '10^{%L}'
set ylabel 'w_K' offset 1,0
at(step, c) = abs(column(1) - step) < 1e-9 && column(c) > 0 ? column(c) : NaN
unset key
set title 'ω Δt = 0.5'
plot for [c = 3:6] file('histories') skip 1 using 2:(at(0.5, c)) with linespoints lt c-2 ps 0.5 notitle
unset ylabel
set format y ''
set title 'ω Δt = 0.9'
plot for [c = 3:6] file('histories') skip 1 using 2:(at(0.9, c)) with linespoints lt c-2 ps 0.5 notitle
# The names stand above all three, in the colours of their curves.
set label 1 'φ = 1' at screen 0.13, screen 0.95 textcolor lt 1
set label 2 'φ = 1/2' at screen 0.3, screen 0.95 textcolor lt 2
set label 3 'velocities lag' at screen 0.5, screen 0.95 textcolor lt 3
set label 4 'mixed' at screen 0.8, screen 0.95 textcolor lt 4
set title 'ω Δt = 1.1'
plot for [c = 3:6] file('histories') skip 1 using 2:(at(1.1, c)) with linespoints lt c-2 ps 0.5 notitle
unset label
unset multiplot
unset title
unset logscale
set key samplen 2 spacing 1.15
set format y '%g'
set ytics autofreq
set xtics autofreq

set terminal svg size 640,680 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_steps.svg'
set multiplot layout 3,1 margins 0.17,0.95,0.12,0.97 spacing 0.05
set xrange [0.45:0.55]
unset xlabel
set format x ''
set ylabel 'separation [m]'
set yrange [0:0.4]
set key inside bottom right
plot file('path') skip 1 using 1:3 with lines lt 7 lw 2 title 'closed form', \
     '' skip 1 using 1:2 with lines lt 1 title 'steered'
set ylabel 'step [periods]' offset 1,0
set autoscale y
set logscale y
set key bottom right
plot file('steps') skip 1 using 1:2 with points lt 1 ps 0.5 title 'accepted', \
     '' skip 1 using 1:3 with points lt 2 pt 2 ps 0.8 title 'refused'
set format x '%g'
set xlabel 'time [periods]'
set yrange [1e-4:100]
set key top right
set ylabel 'contraction' offset 0,0
set format y '10^{%L}'
plot file('steps') skip 1 using 1:5 with lines lt 7 lw 2 title 'aimed at', \
     '' skip 1 using 1:($2 > 0 ? $4 : NaN) with points lt 1 ps 0.5 title 'accepted', \
     '' skip 1 using 1:($3 > 0 ? $4 : NaN) with points lt 2 pt 2 ps 0.8 title 'refused'
unset multiplot

set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_truncation.svg'
set lmargin 10
set logscale xy
set format xy '10^{%L}'
set format x '%g'
set xlabel '{/*1.0 Δt_{lim}}  [periods]'
set ylabel 'largest error [m]'
set xrange [3e-4:0.13]
set yrange [5e-7:1]
set key outside top center vertical maxrows 3
plot file('truncation') skip 1 using 1:2 with points lt 2 pt 4 ps 1.4 title 'φ = 1, TOL 10^{−2}', \
     '' skip 1 using 1:3 with points lt 2 pt 2 ps 0.9 title 'TOL 10^{−6}', \
     '' skip 1 using 1:4 with lines lt 2 lw 1.6 title 'TOL 10^{−10}', \
     '' skip 1 using 1:5 with points lt 1 pt 6 ps 1.4 title 'φ = 1/2, TOL 10^{−2}', \
     '' skip 1 using 1:6 with points lt 1 pt 2 ps 0.9 title 'TOL 10^{−6}', \
     '' skip 1 using 1:7 with lines lt 1 lw 1.6 title 'TOL 10^{−10}', \
     [4e-4:4e-3] 50*x with lines lt 7 notitle, [4e-4:4e-3] 25*x*x with lines lt 7 notitle

set output 'ch03_staggering.svg'
set xlabel 'Δt [s]'
set ylabel 'contraction of a sweep'
set xrange [0.19:2.1]
set yrange [1e-3:20]
set xtics (0.2, 0.5, 1, 2)
set key outside top center vertical maxrows 3
plot x*x with lines lt 1 lw 1.4 notitle, x with lines lt 2 lw 1.4 notitle, x**4 with lines lt 3 lw 1.4 notitle, \
     file('staggering') skip 1 using 1:7 with lines lt 4 lw 1.4 notitle, 1 with lines lt 7 dt 1 notitle, \
     file('staggering') skip 1 using 1:2 with points lt 1 title 'first order, newest', \
     '' skip 1 using 1:3 with points lt 2 title 'first order, previous', \
     '' skip 1 using 1:4 with points lt 3 title 'second order, newest', \
     '' skip 1 using 1:5 with points lt 1 pt 6 ps 1.2 title 'second order, previous', \
     '' skip 1 using 1:6 with points lt 4 title 'decaying, newest'

# The second half: the family of high order.
reset_axes = "unset logscale; unset label; unset title; set autoscale; set format xy '%g'; set xtics autofreq; set ytics autofreq; set key default; set key samplen 2 spacing 1.15 reverse Left; set lmargin -1"

@reset_axes
set terminal svg size 640,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_orders.svg'
set logscale xy
set format y '10^{%L}'
set xlabel 'steps per period'
set ylabel 'largest error [m]'
set xrange [4:3000]
set yrange [2e-16:5]
set key outside right center vertical
plot file('family_orders') skip 1 using 1:10 with lines lt 2 dt (6,4) title 'Radau 1', \
     '' skip 1 using 1:11 with lines lt 3 dt (6,4) title 'Radau 2', \
     '' skip 1 using 1:12 with lines lt 4 dt (6,4) title 'Radau 3', \
     for [s = 1:8] '' skip 1 using 1:s+1 with linespoints lt 1 + (s - 1) % 5 ps 0.4 title sprintf('Gauss %d', s)

@reset_axes
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_guesses.svg'
set logscale y
set format y '10^{%L}'
set xlabel 'sweep'
set ylabel 'change'
set yrange [1e-17:10]
set key top right
positive(c) = column(c) > 0 ? column(c) : NaN
plot file('family_guesses') skip 1 using 1:(positive(2)) with linespoints lt 1 title 'simultaneous, free flight', \
     '' skip 1 using 1:(positive(3)) with linespoints lt 2 title 'sequential, free flight', \
     '' skip 1 using 1:(positive(4)) with linespoints lt 3 title 'simultaneous, extrapolated', \
     '' skip 1 using 1:(positive(5)) with linespoints lt 4 title 'sequential, extrapolated'

@reset_axes
grid = "< awk -F, 'NR > 1 { if (NR > 2 && $1 != last) print \"\"; last = $1; print }' ".file('family_regions')
set contour base
unset surface
set cntrparam levels discrete 1
set datafile separator comma
do for [c = 3:9] {
  set table sprintf('family_%d.dat', c)
  splot grid using 1:2:c
  unset table
}
unset contour
set surface
set datafile separator whitespace
set terminal svg size 640,360 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_regions.svg'
set multiplot layout 1,2 margins 0.11,0.97,0.23,0.8 spacing 0.12
set size ratio -1
set xlabel 'Re z'
set ylabel 'Im z'
set xrange [-13:6]
set yrange [0:14]
set xtics 4
family(c) = sprintf('family_%d.dat', c)
unset key
set title 'all stages at once'
plot family(3) using 1:2 with lines lt 1, family(4) using 1:2 with lines lt 2, family(5) using 1:2 with lines lt 3, \
     family(6) using 1:2 with lines lt 4
set title 'in turn'
set label 1 's = 1' at screen 0.2, screen 0.95 textcolor lt 1
set label 2 's = 2' at screen 0.4, screen 0.95 textcolor lt 2
set label 3 's = 4' at screen 0.6, screen 0.95 textcolor lt 3
set label 4 's = 8' at screen 0.8, screen 0.95 textcolor lt 4
plot family(3) using 1:2 with lines lt 1, family(7) using 1:2 with lines lt 2, family(8) using 1:2 with lines lt 3, \
     family(9) using 1:2 with lines lt 4
unset multiplot
set datafile separator comma
set size noratio

@reset_axes
set output 'ch03_family_stability.svg'
set multiplot layout 1,2 margins 0.13,0.95,0.23,0.78 spacing 0.07
set logscale x
set xlabel '|z|'
set xrange [0.1:1000]
set yrange [0:1.1]
set ylabel 'factor'
unset key
set title 'decay, z < 0'
plot file('family_stability') skip 1 using 1:2 with linespoints lt 1 ps 0.5, \
     '' skip 1 using 1:3 with linespoints lt 2 ps 0.5, '' skip 1 using 1:4 with linespoints lt 3 ps 0.5, \
     exp(-x) with lines lt 7
unset ylabel
set format y ''
set title 'oscillation, Re z = 0'
set label 1 'Gauss 2' at screen 0.13, screen 0.95 textcolor lt 1
set label 2 'Radau 1' at screen 0.36, screen 0.95 textcolor lt 2
set label 3 'Radau 2' at screen 0.59, screen 0.95 textcolor lt 3
set label 4 'exact' at screen 0.82, screen 0.95 textcolor lt 7
plot file('family_stability') skip 1 using 1:5 with linespoints lt 1 ps 0.5, \
     '' skip 1 using 1:6 with linespoints lt 2 ps 0.5, '' skip 1 using 1:7 with linespoints lt 3 ps 0.5, \
     1 with lines lt 7
unset multiplot

@reset_axes
set terminal svg size 640,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_leaps.svg'
set multiplot layout 2,1 margins 0.17,0.95,0.12,0.97 spacing 0.05
unset key
unset xlabel
set format x ''
set ylabel 'y'
set yrange [-2.4:2.4]
plot file('family_leaps') skip 1 using 1:2 with linespoints lt 1 ps 0.3
set format x '%g'
set xlabel 't [s]'
set ylabel 'step [s]'
set autoscale y
set logscale y
set format y '10^{%L}'
plot file('family_leaps') skip 1 using 1:3 with points lt 2 ps 0.4
unset multiplot

@reset_axes
set terminal svg size 640,680 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_passage.svg'
set multiplot layout 3,1 margins 0.17,0.95,0.12,0.97 spacing 0.05
# A fourth root stretches the passage and keeps zero in the middle, which a logarithmic scale has not.
root(t) = t < 0 ? -(-t)**0.25 : t**0.25
set xrange [-0.86:0.86]
set xtics ('−0.1' -0.5623, '−10^{−3}' -0.1778, '0' 0, '10^{−3}' 0.1778, '0.1' 0.5623)
unset xlabel
set format x ''
set logscale y
set format y '10^{%L}'
set ylabel 'step [periods]'
set key top center
plot file('family_passage') skip 1 using (root($1)):2 with points lt 1 ps 0.5 title 'accepted', \
     '' skip 1 using (root($1)):3 with points lt 2 pt 2 title 'refused'
set ylabel 'estimate/TOL'
set yrange [1e-7:1e5]
unset key
plot file('family_passage') skip 1 using (root($1)):($2 > 0 ? $4 : NaN) with points lt 1 ps 0.5 title 'accepted', \
     '' skip 1 using (root($1)):($3 > 0 ? $4 : NaN) with points lt 2 pt 2 title 'refused', 1 with lines lt 7 notitle
set xlabel 'time from the passage [periods], stretched'
set ylabel 'factor'
set yrange [0.2:1e5]
set key on top center
plot file('family_passage') skip 1 using (root($1)):5 with points lt 3 ps 0.5 title 'Φ_K, by the sweeps', \
     '' skip 1 using (root($1)):6 with points lt 4 ps 0.5 title 'by the estimate', 1 with lines lt 7 notitle
unset multiplot

@reset_axes
set terminal svg size 640,380 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_located.svg'
set multiplot layout 1,2 margins 0.13,0.97,0.22,0.86 spacing 0.15
set logscale xy
set format y '10^{%L}'
set xlabel 'steps per period'
set ylabel 'error [s]'
set xrange [14:200]
set yrange [1e-17:1e9]
set xtics (20, 50, 100, 200)
set key top left
set title 'a separation is reached'
floor_at(c) = column(c) > 1e-16 ? column(c) : 1e-16
plot file('family_events') skip 1 using 1:2 with linespoints lt 1 title 'end of the step', \
     '' skip 1 using 1:3 with linespoints lt 2 title 'read off', \
     '' skip 1 using 1:(floor_at(4)) with linespoints lt 3 title 'located'
set title 'three impacts of a ball'
set xlabel 'step [s]'
unset ylabel
set xtics autofreq
set format x '10^{%L}'
set xrange [3e-5:0.1]
plot file('family_bounces') skip 1 using 1:2 with linespoints lt 1 title 'stepped', \
     '' skip 1 using 1:(floor_at(3)) with linespoints lt 3 title 'located'
unset multiplot

@reset_axes
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch03_family_energies.svg'
set logscale y
set format y '10^{%L}'
set xlabel 'period'
set ylabel 'relative error of energy'
set xrange [1:*]
set yrange [*:10]
set key outside top center vertical maxrows 2
plot file('family_energies') skip 1 using 1:5 with lines lt 2 title 'backward Euler', \
     '' skip 1 using 1:4 with lines lt 3 title 'Verlet', \
     '' skip 1 using 1:3 with lines lt 4 title 'Gauss 4, two sweeps', \
     '' skip 1 using 1:2 with lines lt 1 title 'Gauss 4, to rounding'
