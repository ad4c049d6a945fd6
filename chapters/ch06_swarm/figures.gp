# Figures of chapter 6, from what ch06_swarm wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
obstacle(c) = strcol(1) eq 'obstacle' ? column(c) : NaN
target(c) = strcol(1) eq 'target' ? column(c) : NaN
flight(name, c) = strcol(1) eq name ? column(c) : NaN
panel(k, c) = column(1) == k ? column(c) : NaN
grey = '#60808080'

# Figure 6.1: what acts on one member. Arrows are what it feels.
set output 'ch06_interactions.svg'
set terminal svg size 640,260 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-3.1:4.5]
set yrange [-1.3:1.6]
set arrow 1 from 0,0 to -1.15,0.46 size 0.14,22 filled lc rgb '#0072b2' lw 2.4
set arrow 2 from 0,0 to 0.28,-0.75 size 0.14,22 filled lc rgb '#d55e00' lw 2.4
set arrow 3 from 0,0 to -0.55,-0.75 size 0.14,22 filled lc rgb '#808080' lw 2.4
set arrow 4 from 0,0 to 1.5,0.2 size 0.14,22 filled lc rgb '#009e73' lw 2.4
set label 1 'attraction, from afar' at -0.75,-0.02 right tc rgb '#0072b2'
set label 2 'repulsion, from near by' at 0.45,-0.82 left tc rgb '#d55e00'
set label 3 'obstacle' at 1.0,1.5 left tc rgb '#808080'
set label 4 'target' at 4.0,0.05 center tc rgb '#009e73'
set label 5 'away from the obstacle' at -0.6,-0.85 right tc rgb '#808080'
set label 6 'to the target' at 1.7,0.05 left tc rgb '#009e73'
set label 7 'member' at 0.28,-0.25 left
$members << EOD
-2.6,1.04
-2.9,0.6
-2.3,1.3
-0.2,0.55
EOD
$obstacle << EOD
0.62,0.9,0.34
EOD
$target << EOD
4.0,0.53
EOD
$one << EOD
0,0
EOD
plot $obstacle using 1:2:3 with circles fc rgb grey fs solid noborder, \
     $members using 1:2 with points lt 1 ps 1.4, $one using 1:2 with points pt 7 ps 2 lc rgb 'black', \
     $target using 1:2 with points pt 2 ps 1.8 lw 3 lc rgb '#009e73'
unset arrow
unset label
set border 3
set tics nomirror
set grid

# One flight in one picture.
set output 'ch06_way.svg'
set terminal svg size 640,350 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set key outside top center horizontal maxcols 5 samplen 0.3 width -2
set xrange [-1.5:11.5]
set yrange [-2.7:2.7]
set xlabel 'x [m]'
set ylabel 'z [m]' offset 1
set xtics 5
set ytics 2
plot file('course') skip 1 using (obstacle(2)):4:5 with circles fc rgb grey fs solid noborder notitle, \
     for [k = 1:5] file('panels') skip 1 using (panel(k == 5 ? 7 : k - 1, 2)):4 with points lt k pt 7 ps 0.3 notitle, \
     for [k = 1:5] NaN with points lt k pt 7 ps 0.7 title word('start bunched passing unpacked end', k), \
     file('history') skip 1 using (flight('with drag', 3)):4 with lines lc rgb 'black' lw 1.2 dt 1 notitle, \
     file('course') skip 1 using (target(2)):4 with points pt 2 ps 1.4 lw 2.5 lc rgb 'black' notitle

# Figure 6.2: from the side, and along x.
set output 'ch06_start.svg'
set terminal svg size 640,260 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset key
set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.67
set bmargin at screen 0.31
set tmargin at screen 0.95
plot file('course') skip 1 using (obstacle(2)):4:5 with circles fc rgb grey fs solid noborder, \
     file('panels') skip 1 using (panel(0, 2)):4 with points lt 1 ps 0.35, \
     file('course') skip 1 using (target(2)):4 with points pt 2 ps 1.4 lw 2.5 lc rgb 'black'
set lmargin at screen 0.72
set rmargin at screen 0.99
set xrange [2.9:-2.9]
set xlabel 'y [m]'
set xtics 2
unset ylabel
plot file('panels') skip 1 using (panel(0, 3)):4 with points lt 1 ps 0.35, \
     file('course') skip 1 using (obstacle(3)):4:5 with circles fc rgb grey fs solid noborder
unset multiplot

# Figure 6.4: three moments, one below the other.
side = "file('course') skip 1 using (obstacle(2)):4:5 with circles fc rgb grey fs solid noborder, file('history') skip 1 using (flight('with drag', 3)):4 with lines lc rgb 'gray' lw 1.6 dt 1, file('panels') skip 1 using (panel(k, 2)):4 with points lt 1 ps 0.35, file('course') skip 1 using (target(2)):4 with points pt 2 ps 1.4 lw 2.5 lc rgb 'black'"
set output 'ch06_passing.svg'
set terminal svg size 640,760 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set lmargin at screen 0.1
set rmargin at screen 0.98
set xrange [-1.5:11.5]
set xtics 5
set ylabel 'z [m]' offset 1
set multiplot
do for [k = 1:3] {
  set tmargin at screen 1 - 0.31*(k - 1) - 0.02
  set bmargin at screen 1 - 0.31*k + 0.02
  if (k == 3) { set xlabel 'x [m]'; set format x '%g' } else { unset xlabel; set format x '' }
  set label 1 word('bunched passing unpacked', k) at graph 0.02, 0.1
  plot @side
}
unset multiplot

# Figures 6.5 and 6.6: near the target, two moments side by side.
set terminal svg size 640,330 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set format '%g'
set tmargin at screen 0.96
set bmargin at screen 0.25
set xlabel 'x [m]'
set xrange [8.2:12]
set yrange [-1.6:1.6]
set xtics 1
set ytics 1
do for [first = 4:6:2] {
  set output first == 4 ? 'ch06_overshoot.svg' : 'ch06_homing.svg'
  set multiplot
  do for [k = first:first + 1] {
    set lmargin at screen 0.1 + 0.46*(k - first)
    set rmargin at screen 0.52 + 0.46*(k - first)
    if (k == first) { set ylabel 'z [m]' offset 1; set format y '%g' } else { unset ylabel; set format y '' }
    set label 1 word('overshoot undershoot later end', k - 3) at graph 0.03, 0.07
    plot @side
  }
  unset multiplot
}
unset label
set lmargin -1
set rmargin -1
set tmargin -1
set bmargin -1
set size noratio
set format '%g'
set autoscale

# Figure 6.3: best and mean cost by generation.
set output 'ch06_generations.svg'
set terminal svg size 640,460 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
sizes = system("tail -n +2 '".file('generations')."' | cut -d, -f1 | uniq")
of(k, c) = column(1) == word(sizes, k) + 0 ? column(c) : NaN
set xlabel 'generation'
set ylabel 'cost'
set xrange [1:*] noextend
set yrange [0.1:0.3]
set xtics autofreq
set ytics autofreq
set key default
set key inside top right reverse Left samplen 2 spacing 1.15 nobox
plot for [k = 1:words(sizes)] file('generations') skip 1 using (of(k, 2)):3:5 with filledcurves lt k fs transparent solid 0.12 notitle, \
     for [k = 1:words(sizes)] file('generations') skip 1 using (of(k, 2)):4 with lines lt k dt 1 title word(sizes, k).' members', \
     for [k = 1:words(sizes)] file('generations') skip 1 using (of(k, 2)):6 with lines lt k dt (5,4) lw 1.6 notitle

# With drag and without.
set output 'ch06_drag_history.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,1
set lmargin 8
set xrange [0:*]
set yrange [0:12]
unset xlabel
set ylabel 'x of the centre [m]'
set key inside bottom right
plot file('history') skip 1 using (flight('with drag', 2)):3 with lines lt 1 title 'with drag', \
     '' skip 1 using (flight('without', 2)):3 with lines lt 2 dt (6,3) title 'without'
set xlabel 'time [s]'
set ylabel 'mean distance [m]'
set yrange [0:*]
unset key
plot file('history') skip 1 using (flight('with drag', 2)):6 with lines lt 1, \
     '' skip 1 using (flight('without', 2)):6 with lines lt 2 dt (6,3)
unset multiplot
set lmargin -1

# The film: above from the side, below from above.
set autoscale
stats file('film') skip 1 using 1 name 'moment' nooutput
set terminal gif animate delay 8 loop 0 size 480,470 font 'sans-serif,12' background '#ffffff'
set output 'ch06_film.gif'
set size ratio -1
unset key
unset grid
set xrange [-1.5:11.5]
set yrange [-2.7:2.7]
set xtics 5
set ytics 2
unset xlabel
set ylabel offset 1
set lmargin at screen 0.13
set rmargin at screen 0.98
stats file('panels') skip 1 using (column(1) == 0 ? 1 : NaN) name 'members' nooutput
frames = moment_records/members_records
do for [k = 0:frames - 1] {
  first = k*members_records
  last = first + members_records - 1
  set multiplot
  set tmargin at screen 0.98
  set bmargin at screen 0.53
  set ylabel 'z [m]'
  set label 1 sprintf('%.1f s', moment_max*k/(frames - 1)) at graph 0.02, 0.92
  plot file('course') skip 1 using (obstacle(2)):4:5 with circles fc rgb '#c0c0c0' fs solid noborder, \
       file('film') skip 1 every ::first::last using 2:4 with points lt 1 ps 0.5, \
       file('course') skip 1 using (target(2)):4 with points pt 2 ps 1.2 lw 2 lc rgb 'black'
  unset label 1
  set tmargin at screen 0.5
  set bmargin at screen 0.05
  set ylabel 'y [m]'
  plot file('course') skip 1 using (obstacle(2)):3:5 with circles fc rgb '#c0c0c0' fs solid noborder, \
       file('film') skip 1 every ::first::last using 2:3 with points lt 1 ps 0.5, \
       file('course') skip 1 using (target(2)):3 with points pt 2 ps 1.2 lw 2 lc rgb 'black'
  unset multiplot
}
