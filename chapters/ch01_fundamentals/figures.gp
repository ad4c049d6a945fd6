# Figures of chapter 1, from what ch01_fundamentals wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'

set output 'ch01_curves.svg'
set xlabel 'distance [m]'
set ylabel 'force towards the other [N]'
set y2label 'potential [J]'
set y2tics
set border 11
set key bottom right
stats file('curves') skip 1 using 5 name 'V' nooutput
set yrange [-1.2:1.4]
set y2range [-0.6*V_max:0.7*V_max]
plot file('curves') skip 1 using 1:2 with lines lt 6 title 'attraction', \
     '' skip 1 using 1:(-$3) with lines lt 2 dt 2 title 'repulsion, as a pull', \
     '' skip 1 using 1:4 with lines lt 1 lw 3 title 'force C(d)', \
     '' skip 1 using 1:5 axes x1y2 with lines lt 3 lw 3 title 'potential V(d), right scale', \
     0 with lines lt 7 notitle
unset y2label
unset y2tics
set border 3

set output 'ch01_landscape.svg'
set xlabel 'displacement u [m]'
set ylabel 'energy above the balance [J]'
set autoscale y
set yrange [-0.005:*]
set key top center
plot file('landscape') skip 1 using 1:2 with lines lt 1 title 'along the line of centres', \
     '' skip 1 using 1:3 with lines lt 2 title 'across it', \
     '' skip 1 using 1:4 with lines lt 3 dt 2 title 'round the other body'

set output 'ch01_paths.svg'
set terminal svg size 520,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set size ratio -1
set xlabel 'x of one body, seen from the other [m]'
set ylabel 'y [m]'
set autoscale
unset key
stats file('curves') skip 1 using 1:(abs($4)) name 'C' nooutput
balance = C_pos_min_y
set key center center
set parametric
set trange [0:2*pi]
plot balance*cos(t), balance*sin(t) with lines lt 7 title 'balance', \
     file('paths') skip 1 using 4:5 with lines lt 2 title 'kicked across', \
     '' skip 1 using 2:3 with lines lt 1 lw 4 title 'displaced along'
unset parametric
set size noratio
set terminal svg size 640,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded

set output 'ch01_breathing.svg'
set multiplot layout 2,1
set xlabel ''
set ylabel 'separation [m]'
set yrange [0:*]
set key bottom center horizontal
plot file('breathing') skip 1 using 1:2 with lines lt 7 lw 3 dt 1 title 'closed form', \
     '' skip 1 using 1:3 with points lt 1 title 'Runge-Kutta', \
     '' skip 1 using 1:4 with points lt 2 pt 4 title 'Verlet'
set xlabel 'time [periods]'
set ylabel 'error [m]'
set autoscale y
set logscale y
set format y '10^{%L}'
plot file('breathing') skip 1 using 1:($5 > 0 ? $5 : NaN) with linespoints lt 1 title 'Runge-Kutta', \
     '' skip 1 using 1:($6 > 0 ? $6 : NaN) with linespoints lt 2 pt 4 title 'Verlet, four times the steps'
unset multiplot
unset logscale
set format y '%g'
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded

set output 'ch01_similarity.svg'
set xlabel 'time / τ'
set ylabel 'separation / L'
set yrange [0:1.35]
set key top right horizontal maxcols 1
plot file('similarity') skip 1 using 1:3 with lines lt 6 lw 7 dt 1 title 'large scene, scaled law', \
     '' skip 1 using 1:2 with lines lt 1 title 'small scene', \
     '' skip 1 using 1:4 with lines lt 2 title 'large scene, same law'
