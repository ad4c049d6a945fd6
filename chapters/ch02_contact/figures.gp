# Figures of chapter 2, from what ch02_contact wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'

# Compression ends at the second of three points.
set output 'ch02_phases.svg'
stats file('phases') skip 1 using 1 name 'turn' nooutput
turn = turn_median
set arrow 1 from turn, graph 0 to turn, graph 1 nohead lt 7
set xlabel 'time [durations of the impact]'
set ylabel 'normal velocity [m/s]'
set xrange [0:1]
set label 1 'compression' at 0.5*turn, graph 0.04 center
set label 2 'recovery' at 0.5*(1+turn), graph 0.04 center
set yrange [-0.7:2.6]
set key top left
plot file('phases') skip 1 using 1:2 with linespoints lt 1 title 'i, pushed', \
     '' skip 1 using 1:3 with linespoints lt 2 title 'j, i being pushed', \
     '' skip 1 using 1:4 with lines lt 1 dt 2 title 'i, no other forces', \
     '' skip 1 using 1:5 with lines lt 2 dt 2 title 'j, no other forces'
unset arrow
unset label

set output 'ch02_head_on.svg'
set xlabel 'restitution e'
set ylabel 'after the impact'
set yrange [-1.05:1.05]
set key outside top center vertical
plot file('head_on') skip 1 using 1:4 with lines lt 3 lw 3 title 'share of energy kept, e²', \
     '' skip 1 using 1:3 with lines lt 2 title 'velocity of j, −1 m/s before [m/s]', \
     '' skip 1 using 1:2 with lines lt 1 title 'velocity of i, 1 m/s before [m/s]', \
     0 with lines lt 7 notitle

set output 'ch02_oblique.svg'
set xlabel 'dynamic friction μ_d'
set ylabel 'tangential speed after [m/s]'
stats file('oblique') skip 1 using 1 name 'mu' nooutput
stats file('oblique') skip 1 using 2 name 'v' nooutput
stop = 0.5*mu_max
set xrange [0:1.6*stop]
set yrange [-0.3*v_max:1.05*v_max]
set key inside
set arrow 1 from stop, graph 0 to stop, graph 0.6 nohead lt 7
set label 1 'μ_d* ' at stop, graph 0.06 right
set key top right
plot file('oblique') skip 1 using 1:2 with lines lt 1 lw 4 title 'μ_s = μ_d', \
     '' skip 1 using 1:3 with lines lt 2 title 'μ_s = 2 μ_d', \
     '' skip 1 using 1:4 with lines lt 7 lw 2.2 title 'sliding formula alone', \
     0 with lines lt 7 lw 0.8 dt 1 notitle
unset arrow
unset label

set output 'ch02_limits.svg'
set xlabel 'friction μ_s = μ_d'
set ylabel 'energy after over energy before'
set xrange [0:1.4]
set yrange [0:1]
set key outside top center horizontal maxcols 4
angle(a) = column(1) == a ? column(3) : NaN
broken(a) = column(1) == a ? column(4) : NaN
plot file('limits') skip 1 using 2:(angle(60)) with lines lt 3 title '60 degrees', \
     '' skip 1 using 2:(angle(45)) with lines lt 2 title '45 degrees', \
     '' skip 1 using 2:(angle(30)) with lines lt 1 title '30 degrees', \
     '' skip 1 using 2:(broken(60)) with lines lt 3 dt 2 lw 1.4 notitle, \
     '' skip 1 using 2:(broken(45)) with lines lt 2 dt 2 lw 1.4 notitle, \
     '' skip 1 using 2:(broken(30)) with lines lt 1 dt 2 lw 1.4 notitle, \
     file('bottoms') skip 1 using 2:4 with points lt 7 pt 7 ps 1.2 title 'μ_d*'

set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch02_severity.svg'
set multiplot layout 2,1
set lmargin 9
set autoscale x
set xlabel ''
set ylabel 'restitution e'
set yrange [0:*]
set offsets 0, 0, 0.08, 0
set key outside top center horizontal maxcols 2
plot file('severity') skip 1 using 1:3 with lines lt 2 title 'constant', \
     '' skip 1 using 1:2 with lines lt 1 title 'falling to a floor'
set xlabel 'approach speed [m/s]'
unset offsets
set ylabel 'parting speed [m/s]'
unset key
plot file('severity') skip 1 using 1:5 with lines lt 2, \
     '' skip 1 using 1:4 with lines lt 1
set lmargin -1
unset multiplot
set terminal svg size 640,620 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded

set output 'ch02_ledger.svg'
set multiplot
set key bottom left reverse Left samplen 2 spacing 1.15 noopaque nobox
set lmargin 9
set autoscale
set xlabel ''
set ylabel 'energy [J]'
set key outside top center horizontal maxcols 3 width -2
set size 1,0.66
set origin 0,0.34
plot file('ledger') skip 1 using 1:6 with lines lt 7 lw 3 title 'total', \
     '' skip 1 using 1:2 with lines lt 3 title 'bulk motion', \
     '' skip 1 using 1:3 with lines lt 1 title 'relative motion', \
     '' skip 1 using 1:4 with lines lt 5 title 'potential', \
     '' skip 1 using 1:5 with lines lt 2 title 'taken by impacts'
set size 1,0.34
set origin 0,0
set xlabel 'time [s]'
set ylabel 'impacts'
set logscale y
set ytics 100
set format y '10^{%L}'
unset key
plot file('ledger') skip 1 using 1:($7 > 0 ? $7 : NaN) with lines lt 2
unset multiplot

# Spheres in their true size, those in front drawn last: where the cloud's centre is, it is drawn in the middle of a panel.
set terminal svg size 640,250 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch02_places.svg'
reset_margins = "set lmargin -1; set origin 0,0; set size 1,1"
@reset_margins
set bmargin 0
set tmargin 1
stats file('places') skip 1 using 1 name 'moment' nooutput
stats file('places') skip 1 using 3 name 'y' nooutput
at(k) = abs(column(1) - 0.5*k*moment_max) < 1e-9
do for [k = 0:2] { stats file('places') skip 1 using (at(k) ? column(2) : NaN) name sprintf('x%d', k) nooutput }
unset logscale
unset border
unset tics
unset grid
unset xlabel
unset ylabel
unset key
set size ratio -1
set cbrange [0:*]
set cblabel 'speed [m/s]'
set cbtics format '%g'
do for [k = 0:2] {
  set label k+1 sprintf('%.2g s', 0.5*k*moment_max) at 0.9*k, y_mean-0.48 center
}
x(k) = column(2) - (k == 0 ? x0_mean : k == 1 ? x1_mean : x2_mean) + 0.9*k
set xrange [-0.45:2.25]
set yrange [y_mean-0.54:y_max+0.07]
behind_first = "< tail -n +2 '".file('places')."' | sort -t, -k4 -g"
set style fill solid 1.0 border rgb 'black'
plot for [k = 0:2] behind_first using (at(k) ? x(k) : NaN):3:(0.05):5 with circles lc palette lw 0.6
