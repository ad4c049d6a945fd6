# Figures of chapter 7, from what ch07_thermochemistry wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
is(c, name, value) = strcol(c) eq name ? value : NaN

# The bond: its force and its potential, over x from touching to the end.
set output 'ch07_bond.svg'
set terminal svg size 640,390 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
shape(x) = x > 0 && x < 1 ? 16*x**2*(1 - x)**2 : 0
integral(x) = x >= 1 ? 0 : x <= 0 ? 8.0/15 : 8.0/15 - 16*(x**3/3 - x**4/2 + x**5/5)
set xrange [-0.5:1.3]
set yrange [-0.65:1.15]
set samples 400
set xlabel 'x = (d - d_0)/(d_b - d_0)'
set ylabel 'force W, potential'
set key outside top center horizontal maxcols 2
set arrow 1 from 0,-0.65 to 0,1.1 nohead lc rgb 'gray' dt (3,4)
set label 1 'spheres touch' at -0.03,0.6 right
plot shape(x) with lines lt 1 title 'force over F_b m_i m_j', \
     -integral(x) with lines lt 2 title 'potential over F_b m_i m_j (d_b - d_0)'
unset arrow
unset label

# Figures 7.2 and 7.3: one pair.
stats file('distances') skip 1 using 2 every ::0::0 name 'd_e' nooutput
stats file('distances') skip 1 using 2 every ::1::1 name 'd_star' nooutput
stats file('distances') skip 1 using 2 every ::3::3 name 'd_taper' nooutput
set output 'ch07_inflection.svg'
set xrange [0.3:1.5]
set yrange [-1:0.5]
set xlabel 'distance [m]'
set ylabel 'force [N], attraction positive'
unset key
set arrow 1 from d_e_min,-1 to d_e_min,0.42 nohead lc rgb 'gray' dt (3,4)
set arrow 2 from d_star_min,-1 to d_star_min,0.42 nohead lc rgb 'gray' dt (3,4)
set label 1 'd_e' at d_e_min,0.46 center
set label 2 'd^*' at d_star_min,0.46 center
set label 3 'repels' at 0.36,0.1
set label 4 'attracts more and more' at 0.53,-0.2
set label 5 'and less and less' at 1.05,0.1
plot 0 with lines lc rgb 'gray' lw 1, file('pair') skip 1 using 1:2 with lines lt 1
unset label 5
set output 'ch07_cutoff.svg'
set yrange [-0.3:0.35]
set arrow 1 from d_e_min,-0.3 to d_e_min,0.27 nohead lc rgb 'gray' dt (3,4)
set arrow 2 from d_star_min,-0.3 to d_star_min,0.27 nohead lc rgb 'gray' dt (3,4)
set arrow 3 from d_taper_min,-0.3 to d_taper_min,0.27 nohead lc rgb 'gray' dt (3,4)
set label 1 'd_e' at d_e_min,0.3 center
set label 2 'd_c = d^*' at d_star_min,0.3 center
set label 3 'd_c - w' at d_taper_min,0.3 left
unset label 4
set key outside top center horizontal maxcols 3
plot 0 with lines lc rgb 'gray' lw 1 notitle, \
     file('pair') skip 1 using 1:($1 < d_star_min + 1e-9 ? $2 : 0) with lines lt 7 title 'cut off at once', \
     file('pair') skip 1 using 1:3 with lines lt 1 title 'tapered', \
     file('pair') skip 1 using 1:4 with lines lt 2 title 'potential [J]'
unset arrow
unset label

# A chain of particles: its eigenvalues.
set autoscale
set output 'ch07_waves.svg'
set logscale x 2
set format x '%g'
set xlabel 'wave length / spacing'
set ylabel 'eigenvalue [N/m]'
plot 0 with lines lc rgb 'gray' lw 1 notitle, \
     file('waves') skip 1 using 1:2 with linespoints lt 2 title 'all pairs', \
     file('waves') skip 1 using 1:3 with linespoints lt 1 title 'cut off at d^*'
unset logscale

# Figures 7.7 and 7.8: kinetic energy. Without softening there is one curve for all four reactions.
set autoscale
stats file('energies') skip 1 using 3 name 'kappa' nooutput
part(bonds, softens, k, c) = strcol(1) eq bonds && strcol(2) eq softens && abs(column(3)/kappa_max*2**(4 - k) - 1) < 0.01 ? column(c) : NaN
reaction(k) = sprintf('κ = %g MJ/m²', kappa_max/2**(4 - k)/1e6)
set xrange [0:*] noextend
set output 'ch07_energy.svg'
set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,1
set lmargin 11
set key outside top center horizontal maxcols 3
set ylabel 'kinetic energy [J/kg]'
do for [bonds in 'yes no'] {
  set label 1 bonds eq 'yes' ? 'with bonds' : 'without bonds' at graph 0.97, 0.92 right
  if (bonds eq 'no') { set xlabel 'time [s]'; unset key } else { unset xlabel }
  plot file('energies') skip 1 using 4:(part(bonds, 'no', 4, 5)) with lines lc rgb '#909090' lw 6 dt 1 title 'not softened', \
       for [k = 1:4] file('energies') skip 1 using 4:(part(bonds, 'yes', k, 5)) with lines lt k lw 1.6 title reaction(k)
}
unset multiplot

# Figures 7.9 and 7.10: mean temperature.
set output 'ch07_temperature.svg'
set multiplot layout 2,1
set tmargin 2.5
set key inside top left maxcols 1
set ylabel 'mean temperature [K]'
do for [bonds in 'yes no'] {
  set label 1 bonds eq 'yes' ? 'with bonds' : 'without bonds' at graph 0.5, 1.06 center
  if (bonds eq 'no') { set xlabel 'time [s]'; unset key } else { unset xlabel }
  plot for [k = 4:1:-1] file('energies') skip 1 using 4:(part(bonds, 'no', k, 6)) with lines lt k title reaction(k), \
       for [k = 4:1:-1] file('energies') skip 1 using 4:(part(bonds, 'yes', k, 6)) with lines lt k lw 1.4 dt (5,4) notitle
}
unset multiplot
unset label
set lmargin -1
set tmargin -1

# Impulses and forces on the obstacle, over windows of time: Figures 7.14 and 7.15.
set key outside top center horizontal maxcols 3
set xlabel 'time [s]'
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
clouds = '"uncharged" "charged alike" "as the captions"'
set output 'ch07_impulse.svg'
set ylabel 'largest impulse [N s]'
set yrange [0:*]
plot for [k = 1:3] file('windows') skip 1 using (is(1, word(clouds, k), $2)):($3 > 0 ? $3 : NaN) with points lt k title word(clouds, k)
set output 'ch07_force.svg'
set ylabel 'mean force of a window [N]'
plot for [k = 1:3] file('windows') skip 1 using (is(1, word(clouds, k), $2)):4 with lines lt k title word(clouds, k), \
     for [k = 1:3] file('windows') skip 1 using (is(1, word(clouds, k), $2)):5 with lines lt k lw 1.4 dt (5,4) notitle

# Spheres in their true size, those in front drawn last.
unset key
unset grid
set autoscale
set size ratio -1
set style fill solid 1.0 border rgb 'black'
rows(name, first, second, depth) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' '%s' | sort -t, -k%d,%dg", \
  first, second, file(name), depth, depth)

# Figure 7.12: the cloud and the obstacle at the start, by either charge; Figure 7.13: in passing.
set xlabel 'x [m]'
set ylabel 'y [m]' offset 1
set xtics 0.5
set ytics 0.5
set xrange [-0.2:2]
set yrange [-0.3:1.3]
set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch07_ahead.svg'
set arrow 1 from 0.35,1.15 to 0.8,1.15 size 0.05,22 filled lc rgb '#d55e00' lw 2.4
set label 1 '3 m/s' at 0.3,1.15 right tc rgb '#d55e00'
set label 2 'charged or not' at 0.5,-0.15 center
set label 3 'of the same charge, or none' at 1.4,-0.15 center
plot rows('shots', 'uncharged', '0', 5) using 3:4:6 with circles fc rgb '#c8c8c8' lw 0.6
unset arrow
unset label
set output 'ch07_passing.svg'
set terminal svg size 640,720 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.98
set xrange [-0.3:3]
set yrange [-0.35:1.35]
do for [k = 1:2] {
  set tmargin at screen k == 1 ? 0.98 : 0.53
  set bmargin at screen k == 1 ? 0.58 : 0.11
  if (k == 1) { unset xlabel } else { set xlabel 'x [m]' }
  set label 1 word(clouds, k) at graph 0.02, 0.94 front
  plot rows('shots', word(clouds, k), '0.35', 5) using 3:4:6 with circles fc rgb '#c8c8c8' lw 0.6
}
unset multiplot

# Figures 7.16 and 7.17: two clouds, a colour each.
set terminal svg size 640,960 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set rmargin at screen 0.98
set lmargin at screen 0.1
set palette defined (0 '#0072b2', 1 '#d55e00')
set cbrange [1:2]
unset colorbox
set xrange [-2.1:2.1]
set yrange [-1.05:1.05]
do for [U in '1 8'] {
  set output U eq '1' ? 'ch07_slow.svg' : 'ch07_fast.svg'
  set multiplot
  do for [k = 1:3] {
    t = U eq '1' ? word('0 0.5 2', k) : word('0 0.1 0.3', k)
    set tmargin at screen 1 - 0.3*(k - 1) - 0.02
    set bmargin at screen 1 - 0.3*k + 0.02
    if (k == 3) { set xlabel 'x [m]'; set format x '%g' } else { unset xlabel; set format x '' }
    set label 1 t.' s' at graph 0.02, 0.92
    plot rows('meeting_places', U, t, 6) using 4:5:(0.025):3 with circles lc palette lw 0.5
  }
  unset multiplot
}
unset label
set format '%g'

# Figure 7.4: an impact that releases heat.
set output 'ch07_impact.svg'
set terminal svg size 640,250 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set lmargin -1
set rmargin -1
set tmargin -1
set bmargin -1
unset border
unset tics
unset xlabel
unset ylabel
set xrange [0:12]
set yrange [-1.7:1.9]
set style fill solid 1.0 border rgb 'black'
$spheres << EOD
1,0,0.8,300
3.2,0,0.8,300
5.3,0,0.8,330
6.9,0,0.8,330
9.0,0,0.8,370
11.0,0,0.8,370
EOD
set palette defined (300 '#0072b2', 350 '#c8c8c8', 400 '#d5201e')
set cbrange [300:400]
set arrow 1 from 0.7,0 to 1.4,0 size 0.2,22 filled lw 2.4 front
set arrow 2 from 3.5,0 to 2.8,0 size 0.2,22 filled lw 2.4 front
set arrow 3 from 9.2,0 to 8.8,0 size 0.2,22 filled lw 2.4 front
set arrow 4 from 10.8,0 to 11.2,0 size 0.2,22 filled lw 2.4 front
set arrow 5 from 6.1,0.3 to 6.1,1.2 size 0.2,22 filled lc rgb '#d55e00' lw 2.4 front
set arrow 6 from 6.1,-0.3 to 6.1,-1.2 size 0.2,22 filled lc rgb '#d55e00' lw 2.4 front
set label 1 'before' at 2.1,1.4 center
set label 2 'q + H' at 6.1,1.55 center tc rgb '#d55e00'
set label 3 'impulse J' at 6.1,-1.5 center
set label 4 'after' at 10,1.4 center
plot $spheres using 1:2:3:4 with circles lc palette lw 1.2
unset arrow
unset label

# Figures 7.5, 7.6 and 7.11, and the film: colour is temperature, from 300 K to 400 K.
set autoscale xy
stats file('places') skip 1 using 2 name 'picture' nooutput
stats file('places') skip 1 using 3 name 'moment' nooutput
place(bonds, k) = rows('places', bonds, sprintf('%d', k), 6)
set colorbox
set cbtics 50 format '%g'
set border 3
set tics nomirror
set output 'ch07_snapshots.svg'
set terminal svg size 640,700 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-0.8:0.8]
set yrange [-0.8:1]
set xtics 0.5 nomirror
set ytics 0.5 nomirror
set multiplot
do for [row = 1:2] {
  do for [column = 1:2] {
    set lmargin at screen column == 1 ? 0.09 : 0.51
    set rmargin at screen column == 1 ? 0.46 : 0.88
    set tmargin at screen row == 1 ? 0.98 : 0.50
    set bmargin at screen row == 1 ? 0.56 : 0.08
    if (row == 1 && column == 2) { set colorbox user origin 0.9,0.3 size 0.02,0.4 } else { unset colorbox }
    set format y column == 1 ? '%g' : ''
    set format x row == 2 ? '%g' : ''
    k = column*picture_max/2
    set label 1 sprintf('%s, %.2f s', row == 1 ? 'bonds' : 'no bonds', k*moment_max/picture_max) at graph 0.03, 0.95
    plot place(row == 1 ? 'yes' : 'no', k) using 4:5:(0.025):7 with circles lc palette lw 0.4
  }
}
unset multiplot
unset label
set lmargin -1
set rmargin -1
set tmargin -1
set bmargin -1
set format '%g'

set output 'ch07_structures.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set colorbox default
set cblabel 'temperature [K]'
set autoscale xy
stats place('yes', picture_max) using (column(8) == 1 ? $4 : NaN) name 'x' nooutput
stats place('yes', picture_max) using (column(8) == 1 ? $5 : NaN) name 'y' nooutput
half = 0.05 + 0.5*((x_max - x_min) > (y_max - y_min) ? x_max - x_min : y_max - y_min)
set xrange [0.5*(x_min + x_max) - half:0.5*(x_min + x_max) + half]
set yrange [0.5*(y_min + y_max) - half:0.5*(y_min + y_max) + half]
set xtics 0.1
set ytics 0.1
plot place('yes', picture_max) using 4:5:(0.025) with circles fc rgb '#e8e8e8' fs solid border rgb '#b0b0b0' lw 0.4, \
     place('yes', picture_max) using (column(8) == 1 ? $4 : NaN):5:(0.025):7 with circles lc palette lw 0.8

set terminal gif animate delay 8 loop 0 size 480,440 font 'sans-serif,12' background '#ffffff'
set output 'ch07_film.gif'
unset border
unset tics
set xrange [-0.75:0.75]
set yrange [-0.75:0.75]
do for [k = 0:picture_max] {
  set label 1 sprintf('%.2f s', k*moment_max/picture_max) at graph 0.03, 0.96
  plot place('yes', k) using 4:5:(0.025):7 with circles lc palette lw 0.6
}
