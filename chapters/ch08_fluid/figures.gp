# Figures of chapter 8, from what ch08_fluid wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
those(name, k) = sprintf("< awk -F, '$1 == %g' '%s'", k, file(name))

# Sixteen vortices. An image fills each panel; arrows stand at every fourth of the cells that are drawn.
edge = 2*pi
set palette defined (-1 '#0072b2', 0 '#f7f7f7', 1 '#d55e00')
set cbrange [-3.5:3.5]
set xrange [0:edge]
set yrange [0:edge]
set size ratio -1
unset key
unset grid
unset colorbox
unset tics
set border 15 lc rgb '#a0a0a0'
set output 'ch08_vortices.svg'
set terminal svg size 640,660 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,2 margins 0.01,0.99,0.01,0.95 spacing 0.02,0.06
do for [k in '0 8 16 32'] {
  set title sprintf('t = %g', 0.75*k) offset 0,-0.7
  plot those('vortices', k + 0) using 3:4:5 with image, \
       '' using (int($0) % 32 % 3 == 1 && int($0/32) % 3 == 1 ? $3 : NaN):4:(0.3*$6):(0.3*$7) with vectors size 0.12,25 filled lw 1.2 lc rgb '#202020'
}
unset multiplot
unset title

# The film of the same, in a few shades, so that it is small.
rows(k) = sprintf("< awk -F, '$1 == %d { if ($4 != y) print \"\"; y = $4; print }' '%s'", k, file('vortices'))
set terminal gif animate delay 12 loop 0 size 340,360 font 'sans-serif,12' background '#ffffff'
set output 'ch08_film.gif'
set lmargin at screen 0.01; set rmargin at screen 0.99; set tmargin at screen 0.93; set bmargin at screen 0.01
set palette maxcolors 9
set xrange [0.1:6.1]
set yrange [0.1:6.1]
set pm3d map interpolate 5,5
do for [k = 0:40] {
  set title sprintf('t = %.2f', 0.75*k) offset 0,-0.7
  splot rows(k) using 3:4:5 with pm3d
}
reset
load style

# Sound: profiles, each higher than the one before.
set output 'ch08_sound.svg'
set terminal svg size 640,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xlabel 'x [m]'
set ylabel 't [s]'
unset key
set xrange [0:1]
set yrange [-0.008:0.345]
set ytics 0.1
lift = 0.024
profile(k) = sprintf("< awk -F, '$1 == 256 && $2 == %d' '%s'", k, file('sound'))
plot for [k = 0:15] profile(k) using 4:($3 + lift*$6) with lines dt 1 lw 3.4 lc rgb '#b8b8b8', \
     for [k = 0:15] profile(k) using 4:($3 + lift*$5) with lines lt 1 lw 1.6

# Kinetic energy of vortices.
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch08_decay.svg'
set xrange [0:20]
set yrange [0:1.05]
set ytics 0.2
set xlabel 't'
set ylabel 'kinetic energy, over that at the start'
set key outside top center horizontal
plot for [k = 1:4] those('decay', word('0 0.01 0.03 0.1', k) + 0) using 2:4 with lines dt 1 lc rgb '#b8b8b8' lw 4 notitle, \
     for [k = 1:4] those('decay', word('0 0.01 0.03 0.1', k) + 0) every 2 using 2:3 with points lt k title 'ν = '.word('0 0.01 0.03 0.1', k)

# Between walls.
liquid(name) = sprintf("< awk -F, '$1 == \"%s\"' '%s'", name, file('couette'))
set output 'ch08_couette.svg'
set terminal svg size 640,440 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [0:1]
set yrange [0:1]
set xtics 0.5
set xlabel 'u/U'
set multiplot layout 1,2 margins 0.11,0.98,0.21,0.86 spacing 0.09
set ylabel 'y/h' offset 1
unset key
set label 1 't ν/h² = 0.005, 0.02, 0.05, 0.1, 0.2, 2' at graph 0.5, 1.06 center
plot for [t in '0.005 0.02 0.05 0.1 0.2 2'] sprintf("< awk -F, '$1 == \"even\" && $2 == %s' '%s'", t, file('couette')) using 5:3 with lines dt 1 lw 4 lc rgb '#b8b8b8', \
     for [t in '0.005 0.02 0.05 0.1 0.2 2'] sprintf("< awk -F, '$1 == \"even\" && $2 == %s' '%s'", t, file('couette')) using 4:3 with lines lt 1 lw 1.4
unset ylabel
set format y ''
set key inside top left Left reverse
set label 1 'the upper wall is the hot one'
plot liquid('thin') using 5:3 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, \
     sprintf("< awk -F, '$1 == \"even\" && $2 == 2' '%s'", file('couette')) using 4:3 with lines lt 1 lw 1.4 title 'one viscosity', \
     liquid('thin') using 4:3 with points lt 2 ps 0.5 title 'thinning'
unset multiplot
unset label
set format y '%g'
set xtics auto
set ytics auto

# Shocks.
gas(M) = sprintf("< awk -F, '$1 == %s && $2 == 64' '%s'", M, file('shock'))
set output 'ch08_shock.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-12:8]
set multiplot layout 2,1 margins 0.16,0.97,0.16,0.97 spacing 0.05
unset xlabel
set format x ''
set yrange [0:1.1]
set ylabel 'u/u_1'
set key inside bottom left Left reverse
plot for [k = 1:2] gas(word('1.5 3', k)) using 3:6 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, \
     for [k = 1:2] gas(word('1.5 3', k)) using 3:4 with points lt k ps 0.5 title 'M = '.word('1.5 3', k)
set format x '%g'
set xlabel 'x/(μ/ρ_1 u_1)'
set ylabel 'θ/θ_1'
set yrange [0.8:2.9]
unset key
plot for [k = 1:2] gas(word('1.5 3', k)) using 3:7 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, \
     for [k = 1:2] gas(word('1.5 3', k)) using 3:5 with points lt k ps 0.5
unset multiplot

# The step that sweeps choose.
set terminal svg size 640,360 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch08_step.svg'
set xrange [0:0.9]
set yrange [0:1.1]
set xlabel 't c_s/D'
set ylabel 'z'
set label 1 'beyond this line sweeps do not contract' at 0.03,1.05 tc rgb '#707070'
plot 1 with lines lt 7 dt 1, 10**(-6.0/20) with lines lt 7 lw 2 dt (8,4), file('step') skip 1 using 1:2 with steps lt 1, '' skip 1 using 1:2 with points lt 1 ps 0.4
unset label

# The drag coefficient, branch by branch, and at what speeds spheres fall.
reset
load style
branch(k) = sprintf("< awk -F, '$1 == %d' '%s'", k, file('coefficient'))
set output 'ch08_coefficient.svg'
set terminal svg size 640,380 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set logscale xy
set format '10^{%T}'
set xrange [1e-2:1e7]
set yrange [0.05:3000]
set xlabel 'Re'
set ylabel 'C_D'
unset key
plot for [k = 0:4] branch(k) using 2:3 with lines lt 1 lw 2.6

set output 'ch08_terminal.svg'
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
root(k) = sprintf("< awk -F, '$2 == %d' '%s'", k, file('terminal'))
set multiplot layout 1,2 margins 0.15,0.97,0.21,0.95 spacing 0.12
set xrange [1e-4:1]
set yrange [1e-2:30]
set xlabel 'diameter [m]'
set ylabel 'speed [m/s]'
plot file('terminal') skip 1 using 1:3 with points lt 1 pt 7 ps 0.25
unset logscale
set format '%g'
set xrange [0:3]
set yrange [0:5]
set xlabel 't [s]'
unset ylabel
unset key
set label 1 'thrown' at 0.7,4.1
set label 2 'dropped' at 0.7,1.55
plot sprintf("< awk -F, '$1 == 0' '%s'", file('falls')) using 2:3 with lines lt 1, \
     sprintf("< awk -F, '$1 == 3.5' '%s'", file('falls')) using 2:3 with lines lt 2
unset multiplot
unset label

# A slice of the element. Fluid: the bluer the faster; particles: coloured by temperature, with their velocities.
reset
load style
field(k) = word('"none" "as it is" "ended at d*"', k + 1)
slice(name, k, picture) = sprintf("< awk -F, '$1 == \"%s\" && $2 == %d' '%s'", field(k), picture, file(name))
faster(u) = (u > 0.25 ? 1 : u/0.25)
red(u) = 255 - 125*faster(u)
green(u) = 255 - 75*faster(u)
set palette defined (300 '#3b0f70', 375 '#8c2981', 450 '#de4968', 525 '#fe9f6d', 600 '#fcd225')
set cbrange [300:600]
set xrange [0:1]
set yrange [0:1]
set size ratio -1
unset key
unset grid
unset tics
set border 15 lc rgb '#a0a0a0'
set cbtics 100
set output 'ch08_snapshots.svg'
set terminal svg size 640,540 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,3 margins 0.06,0.99,0.17,0.94 spacing 0.015,0.02
do for [k = 0:1] {
  do for [n = 1:3] {
    picture = word('4 12 40', n) + 0
    if (k == 0) { set title sprintf('t = %g s', picture/40.0) offset 0,-0.7 } else { unset title }
    if (n == 1) { set ylabel (k == 0 ? 'without near fields' : 'with near fields') offset 1 } else { unset ylabel }
    if (k == 1 && n == 2) {
      set colorbox horizontal user origin 0.26,0.115 size 0.5,0.025
      set cblabel 'temperature [K]' offset 0,0.6
    } else { unset colorbox; unset cblabel }
    plot slice('slice', k, picture) using 3:4:(red($5)):(green($5)):(255) with rgbimage, \
         slice('snapshots', k, picture) using 3:4:(0.2*$5):(0.2*$6) with vectors size 0.022,24 lw 1 lc rgb '#303030', \
         '' using 3:4:7 with points pt 7 ps 0.42 lc palette
  }
}
unset multiplot

# The film of the same.
set terminal gif animate delay 12 loop 0 size 560,320 font 'sans-serif,12' background '#ffffff'
set output 'ch08_swarm.gif'
unset colorbox
unset cblabel
unset ylabel
do for [picture = 0:40] {
  set multiplot layout 1,2 margins 0.01,0.99,0.01,0.92 spacing 0.02
  do for [k = 0:1] {
    set title sprintf('%s near fields, t = %.3f s', k == 0 ? 'without' : 'with', picture/40.0) offset 0,-0.7
    plot slice('snapshots', k, picture) using 3:4:7 with points pt 7 ps 0.9 lc palette
  }
  unset multiplot
}

# Figures 8.4 and 8.5: means.
reset
load style
mean(k) = sprintf("< awk -F, '$1 == \"%s\"' '%s'", field(k), file('means'))
set output 'ch08_means.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,2 margins 0.12,0.97,0.16,0.97 spacing 0.06,0.06
set xrange [0:1]
set xtics 0.5
do for [row = 0:1] {
  if (row == 0) { set yrange [0:1.05]; set ytics 0.5; unset xlabel; set format x '' } else { set yrange [290:610]; set ytics 100; set xlabel 't [s]'; set format x '%g' }
  do for [k in '1 0'] {
    if (k eq '1') { set ylabel (row == 0 ? 'velocity [m/s]' : 'temperature [K]') offset 0.5; set format y '%g' } else { unset ylabel; set format y '' }
    if (row == 0) {
      set label 1 (k eq '1' ? 'with near fields' : 'without') at graph 0.97,0.94 right
      set key at graph 0.99,0.86 right top vertical samplen 1.5
      plot mean(k + 0) using 2:9 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, '' using 2:10 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, \
           mean(k eq '1' ? 2 : 0) using 2:6 with lines lt 4 lw 1.6 dt (5,4) title (k eq '1' ? 'ended at d^*' : ''), \
           for [c = 3:6] mean(k + 0) using 2:c with lines lt c - 2 title (k eq '1' ? '' : word('v_x v_y v_z speed', c - 2))
    } else {
      unset label 1
      if (k eq '1') { set key inside top right vertical } else { unset key }
      plot mean(k + 0) using 2:12 with lines dt 1 lw 4 lc rgb '#b8b8b8' notitle, \
           '' using 2:7 with lines lt 2 title 'particles', '' using 2:8 with lines lt 1 title 'fluid'
    }
  }
}
unset multiplot

# Figure 8.6: the step in time.
reset
load style
stats file('particle_step') skip 1 using 7 name 'sound' nooutput
step_of(k, spare, accepted) = sprintf("< awk -F, '$1 == \"%s\" && $2 == %d && $3 == %d && $6 == %d' '%s'", word('without with', k + 1), spare, spare == 0 ? 1 : 2, accepted, file('particle_step'))
# Only some steps are refused: of those that are not there a point beyond the frame stands for the key.
some(name) = name.'; echo ,,,-1,-1'
set output 'ch08_particle_step.svg'
set terminal svg size 640,520 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,1 margins 0.11,0.96,0.175,0.87 spacing 0.06
set yrange [0:5.6]
set xrange [0:*]
set ylabel 'step [ms]'
unset xlabel
set format x ''
do for [spare in '0 2'] {
  if (spare eq '0') { set key at screen 0.53,0.99 center top horizontal maxcols 2 samplen 1.5 width -3 } else { unset key; set xlabel 't [s]'; set format x '%g' }
  set label 1 (spare eq '0' ? 'aims at K_d = 10 contractions, p = 1' : 'aims at K_d − 2, p = 2') at graph 0.98,0.1 right
  plot 1e3*sound_max with lines lt 7 lw 2 dt (8,4) notitle, \
       step_of(0, spare + 0, 1) using 4:(1e3*$5) with steps lt 1 title 'without near fields', \
       step_of(1, spare + 0, 1) using 4:(1e3*$5) with steps lt 2 title 'with near fields', \
       some(step_of(0, spare + 0, 0)) using 4:(1e3*$5) with points lt 1 pt 5 ps 0.4 title 'refused, without', \
       some(step_of(1, spare + 0, 0)) using 4:(1e3*$5) with points lt 2 pt 7 ps 0.4 title 'refused, with'
}
unset multiplot
unset label

# Cells and steps.
reset
load style
set output 'ch08_cells.svg'
set terminal svg size 640,380 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
width(name) = sprintf("< awk -F, '$1 == \"%s\"' '%s'", name, file('cells'))
set xlabel 'cells along an edge'
set ylabel 'mean of v_x [m/s]'
set key top left
set xrange [6:*]
set ytics 0.01
plot width('1/8 m') using 2:3 with linespoints lt 1 title 'w = 1/8 m', width('h') using 2:3 with linespoints lt 2 title 'w = h'

set output 'ch08_shorter.svg'
by(name) = sprintf("< awk -F, '$1 == \"%s\"' '%s'", name, file('shorter'))
set logscale xy
set format y '10^{%T}'
set xtics (0.0005, 0.001, 0.002, 0.004, 0.008)
set xrange [0.0004:0.01]
set yrange [1e-7:1]
set ytics 100
set xlabel 'step [s]'
set ylabel 'error of velocities, relative'
set key top left horizontal maxcols 3
plot by('one sweep') using 2:3 with linespoints lt 1 title 'one sweep', by('six sweeps') using 2:3 with linespoints lt 2 title 'six sweeps', \
     by('RK4') using 2:3 with linespoints lt 3 title 'RK4'
reset
load style

# Drawings: no axes.
unset tics
unset border
unset grid
unset key
unset xlabel
unset ylabel
set size ratio -1
set style fill solid 1.0 border rgb '#606060'
place_x(k) = word('0.45 1.35 0.8 1.6', k) + 0
place_y(k) = word('0.5 0.75 1.45 1.6', k) + 0
drag_x(k) = word('0.4 0.36 0.28 -0.4', k) + 0
drag_y(k) = word('0.1 -0.18 0.3 -0.18', k) + 0

# Figure 8.1: particles in a fluid are a fluid that is pushed, and particles that are dragged.
set output 'ch08_decomposition.svg'
set terminal svg size 640,260 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-0.1:8.1]
set yrange [-0.75:2.25]
do for [panel = 0:2] {
  o = 3*panel
  set object 10*panel + 1 rectangle from o,0 to o + 2,2 fc rgb (panel < 2 ? '#d8e6f3' : '#ffffff') fs solid border rgb '#606060'
  do for [k = 1:4] {
    if (panel != 1) { set object 10*panel + 1 + k circle at o + place_x(k),place_y(k) size 0.15 fc rgb '#f0a020' fs solid border rgb '#606060' front }
    if (panel == 1) { set arrow 10*panel + k from o + place_x(k),place_y(k) to o + place_x(k) - drag_x(k),place_y(k) - drag_y(k) size 0.14,22 filled front lt 1 lw 1.8 }
    if (panel == 2) { set arrow 10*panel + k from o + place_x(k),place_y(k) to o + place_x(k) + drag_x(k),place_y(k) + drag_y(k) size 0.14,22 filled front lt 2 lw 1.8 }
  }
  set label 10*panel + 1 word('"particles in a fluid" "the fluid, pushed" "particles, dragged"', panel + 1) at o + 1,-0.35 center
}
set label 2 '=' at 2.5,1 center font ',24'
set label 3 '+' at 5.5,1 center font ',24'
set label 4 '−Ψ^{drag}' at 4.92,0.2 right tc lt 1
set label 5 'Ψ^{drag}' at 7.92,0.2 right tc lt 2
plot NaN
unset arrow
unset label
unset object

# Figure 8.2: a representative element of a flow with particles.
set output 'ch08_element.svg'
set terminal svg size 640,330 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-0.2:8.4]
set yrange [-0.55:3.75]
set object 1 rectangle from 0,0.1 to 4,3.4 fc rgb '#d8e6f3' fs solid noborder behind
stream(x, k) = x > 0.05 && x < 3.95 ? 0.45 + 0.55*k + 0.16*sin(1.6*x + 0.5*k) : NaN
do for [k = 0:39] {
  x = 0.15 + 0.38*(k % 10) + 0.09*sin(7.0*k)
  y = 0.4 + 0.78*(k/10) + 0.2*sin(11.0*k + 1)
  set object 10 + k circle at x,y size 0.055 fc rgb '#f0a020' fs solid border rgb '#606060' front
}
set object 2 rectangle from 2.0,1.45 to 2.75,2.2 fs empty border rgb '#c01818' lw 2 front
set arrow 1 from 2.75,2.2 to 5.0,3.3 nohead lc rgb '#c01818' dt (4,4) front
set arrow 2 from 2.75,1.45 to 5.0,0.3 nohead lc rgb '#c01818' dt (4,4) front
set object 3 rectangle from 5,0.3 to 8,3.3 fc rgb '#d8e6f3' fs solid border rgb '#c01818' lw 2
do for [k = 0:6] {
  x = 5.5 + 0.95*(k % 3) + 0.2*sin(5.0*k)
  y = 0.75 + 0.9*(k/3) + 0.2*sin(3.0*k + 2)
  set object 60 + k circle at x,y size 0.2 fc rgb '#f0a020' fs solid border rgb '#606060' front
}
set object 80 circle at 8,2.45 size 0.2 fc rgb '#f0a020' fs solid border rgb '#606060' front
set object 81 circle at 5,2.45 size 0.2 fc rgb '#ffffff' fs solid border rgb '#606060' dt (3,3) front
set arrow 3 from 7.75,2.45 to 8.38,2.45 size 0.13,22 filled lt 2 lw 2 front
set arrow 4 from 4.62,2.45 to 5.3,2.45 size 0.13,22 filled lt 2 lw 2 front
set arrow 5 from 5,-0.02 to 8,-0.02 heads size 0.12,22 filled lw 1.2
set label 1 'D' at 6.5,-0.25 center
set label 2 'a flow with particles' at 2,-0.25 center
plot for [k = 0:5] stream(x, k) with lines lc rgb '#7fa8cc' lw 1.4 dt 1
