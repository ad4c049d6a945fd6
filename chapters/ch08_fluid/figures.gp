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
