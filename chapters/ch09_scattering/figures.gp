# Figures of chapter 9, from what ch09_scattering wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
those(name, law) = sprintf("< awk -F, '$1 == \"%s\"' '%s'", law, file(name))
of(law, c) = strcol(1) eq law ? column(c) : NaN
light = '"n^ = 1.5" "n^ = 2" "n^ = 4" "n^ = 10" "n^ = 100"'
fluids = '"Z^ = 2 and c^ = 0.5" "Z^ = 2 and c^ = 2" "Z^ = 10 and c^ = 0.5" "Z^ = 10 and c^ = 2"'

# Figures 9.7, 9.9 and 9.10: what is left along the beam.
set terminal svg size 640,440 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
hats(text) = system("echo '".text."' | sed 's/n^/n̂/; s/Z^/Ẑ/; s/c^/ĉ/'")
set key outside top center horizontal maxcols 3
set xlabel 'L = b/(V/N_p)^{1/3}'
set ylabel 'I_x/||I(0)||'
set xzeroaxis lc rgb 'gray' lw 1
array names[3] = ['spheres', 'oblates', 'sound']
array figures[3] = ['forward', 'oblates', 'sound']
do for [k = 1:3] {
  set output 'ch09_'.figures[k].'.svg'
  laws = k < 3 ? light : fluids
  set xrange [k == 2 ? 0.23 : 0.24:k == 2 ? 0.64 : k == 1 ? 0.435 : 0.41]
  plot for [j = 1:words(laws)] those(names[k], word(laws, j)) using 2:4:5 with yerrorlines lt j title hats(word(laws, j))
}
set output 'ch09_forward_sum.svg'
set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [0.24:0.435]
set yrange [0:*]
set multiplot layout 2,1
set lmargin 10
unset xlabel
set ylabel 'forward sum over ||I(0)||'
plot for [j = 1:words(light)] those('spheres', word(light, j)) using 2:6:7 with yerrorlines lt j title hats(word(light, j))
set xlabel 'L'
set ylabel 'absorbed'
set yrange [0:1]
unset key
plot for [j = 1:words(light)] those('spheres', word(light, j)) using 2:8 with linespoints lt j
unset multiplot
set lmargin -1

# Where running means had settled.
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch09_settling.svg'
set autoscale y
set xlabel 'L'
set ylabel 'difference from the mean of all'
set key top left
plot file('spheres') skip 1 using 2:(0):(of('n^ = 10', 5)) with yerrorbars lt 7 pt 0 title 'standard error of all', \
     file('spheres') skip 1 using 2:(of('n^ = 10', 10) - $4) with points lt 2 title 'where it settled', \
     file('spheres') skip 1 using 2:(of('n^ = 10', 10) - $4):(sprintf('   %d', $9)) with labels left notitle
unset xzeroaxis

# Figure 9.8.
set output 'ch09_integrated.svg'
set key top left
set logscale x
set xrange [1:100]
set yrange [0:1]
set xlabel 'n̂'
set ylabel 'reflectance'
plot file('integrated') skip 1 using 1:2 with lines lt 1 title 'sphere in a beam, F', \
     file('integrated') skip 1 using 1:3 with lines lt 2 title 'planar quarter', \
     file('integrated') skip 1 using 1:4 with lines lt 7 title 'at normal incidence'
unset logscale

# What has become of the power, one share upon the other.
set output 'ch09_ledger.svg'
set key outside top center horizontal maxcols 3
set xrange [0.1:3]
set xlabel 'length of the paths [m]'
set ylabel 'share of the power'
share(k) = sum [j = 2:k] column(j)
plot for [k = 6:2:-1] file('ledger') skip 1 using 1:(share(k)) with filledcurves x1 fc rgb word('#0072b2 #009e73 #d55e00 #cc79a7 #909090', k - 1) \
     title word('"on its way" "through" "back" "at the sides" "absorbed"', k - 1)

# Bodies in their true size, those in front drawn last. The cube is seen along z.
unset key
unset grid
set size ratio -1
set style fill solid 1.0 border rgb '#a8a8a8'
set xlabel 'x [m]'
set ylabel 'y [m]' offset 1
set xtics 0.5
set ytics 0.5
set xrange [-0.2:1.2]
set yrange [-0.1:1.1]
set palette defined (0 '#f0a020', 0.2 '#f07010', 0.6 '#c01818', 1 '#600010')
set cbrange [0:1]
unset colorbox
by_depth(name) = sprintf("< sort -t, -k3,3g '%s'", file(name))

# Figure 9.6: a line is as long as the power of its ray. Spheres behind the middle are a background.
moment(k) = sprintf("< awk -F, '$1 == %d' '%s'", k, file('moments'))
reach = 0.06
set output 'ch09_progress.svg'
set terminal svg size 640,600 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot
do for [k = 1:4] {
  set lmargin at screen k % 2 == 1 ? 0.14 : 0.58
  set rmargin at screen k % 2 == 1 ? 0.55 : 0.99
  set tmargin at screen k < 3 ? 0.98 : 0.52
  set bmargin at screen k < 3 ? 0.57 : 0.11
  set format x k < 3 ? '' : '%g'
  set format y k % 2 == 1 ? '%g' : ''
  if (k < 3) { unset xlabel } else { set xlabel 'x [m]' }
  if (k % 2 == 1) { set ylabel 'y [m]' offset 1 } else { unset ylabel }
  picture = word('3 8 16 28', k)
  set label 1 sprintf('%.2f m', picture*0.05) at graph 0.03, 0.94 front
  plot by_depth('scatterers') skip 1 using ($3 < 0.5 ? $1 : NaN):2:4 with circles fc rgb '#f4f4f4' lw 0.3, \
       moment(picture + 0) using 3:4:(reach*$6*$8):(reach*$7*$8):8 with vectors nohead lc palette lw 1.6, \
       moment(picture + 0) using 3:4:8 with points lc palette pt 7 ps 0.4
}
unset multiplot
unset label
set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1
set format '%g'

# Six rays. A ray is drawn from turn to turn, as thick as its power.
set output 'ch09_paths.svg'
set terminal svg size 640,560 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xlabel 'x [m]'
set ylabel 'y [m]' offset 1
set style fill solid 1.0 border rgb '#606060'
set object 1 rectangle from 0,0 to 1,1 fs empty border rgb '#606060' lw 1.2
segments = sprintf("< awk -F, '$1 == ray && NR > 2 { print x, y, $2 - x, $3 - y, power, ray } { ray = $1; x = $2; y = $3; power = $4 }' OFS=, '%s'", file('turns'))
plot file('hit') skip 1 using 1:2:3 with circles fc rgb '#e0e0e0' lw 0.8, \
     for [k = 0:5] for [w = 1:4] segments using ($6 == k && ceil(4*$5) == w ? $1 : NaN):2:3:4 with vectors head size 0.022,20 filled lt k + 1 dt 1 lw 0.7*w
unset object

# Figures 9.1 and 9.3: the system. Rays come in over the lit part of the face.
set output 'ch09_system.svg'
set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset tics
unset border
unset xlabel
unset ylabel
set style fill solid 1.0 border rgb '#707070'
set xrange [-0.75:1.15]
set yrange [-0.1:1.1]
set object 1 rectangle from 0,0 to 1,1 fs empty border rgb '#606060' lw 1.6 front
do for [k = 0:10] { set arrow k + 1 from -0.55,0.25 + 0.05*k to -0.02,0.25 + 0.05*k size 0.03,20 filled lc rgb '#c01818' lw 1.6 front }
set arrow 20 from -0.62,0.25 to -0.62,0.75 heads size 0.02,20 filled lw 1.2
set label 1 'D/2' at -0.65,0.5 right
set label 2 'beam of rays' at -0.3,0.85 center tc rgb '#c01818'
set label 3 'N_p scatterers in a cube of edge D' at 0.5,1.06 center
plot by_depth('scatterers') skip 1 using 1:2:4 with circles fc rgb '#d8e4f0' lw 0.5
unset arrow
unset label
unset object

# Figure 9.2: wave fronts across the propagation vector.
set output 'ch09_front.svg'
set terminal svg size 640,260 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [0:10]
set yrange [0:4]
set size ratio -1
angle = 0.25
along(u, v) = 1.5 + u*cos(angle) - v*sin(angle)
above(u, v) = 1.4 + u*sin(angle) + v*cos(angle)
do for [k = 0:5] { set arrow k + 1 from along(k, -1.2),above(k, -1.2) to along(k, 1.2),above(k, 1.2) nohead lt 1 }
set arrow 10 from along(5, 0),above(5, 0) to along(7, 0),above(7, 0) size 0.25,20 filled lt 2
set label 1 'k' at along(7.2, 0),above(7.2, 0) tc lt 2
set arrow 11 from along(2, -0.8),above(2, -0.8) to along(3, -0.8),above(3, -0.8) heads size 0.12,20 filled lw 1.2
set label 2 'λ' at along(2.5, -0.55),above(2.5, -0.55) center
set label 3 'planes of equal phase' at along(0.8, 1.7),above(0.8, 1.7) center tc lt 1
plot NaN
unset arrow
unset label

# Figure 9.4: fields at a surface. A circled dot points to the reader.
set output 'ch09_fresnel.svg'
set terminal svg size 640,330 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-3:9.4]
set yrange [-2.6:3]
do for [side = 0:1] {
  m = 6.4*side
  base = 20*side
  set object base + 1 rectangle from m - 2.9,-2.6 to m + 2.9,0 fc rgb '#e4ecf4' fs noborder behind
  set arrow base + 1 from m,-2.5 to m,2.7 nohead lc rgb '#808080' dt (4,4)
  set arrow base + 2 from m - 2.3,2.3 to m,0 size 0.22,20 filled lc rgb '#c01818' lw 2
  set arrow base + 3 from m,0 to m + 2.3,2.3 size 0.22,20 filled lc rgb '#c01818' lw 2
  set arrow base + 4 from m,0 to m + 1.2,-2.3 size 0.22,20 filled lc rgb '#c01818' lw 2
  set label base + 1 'θ' at m - 0.45,1.1 center
  set label base + 2 'θ' at m + 0.45,1.1 center
  set label base + 3 'θ_t' at m + 0.33,-1.2 center
  if (side == 0) {
    set arrow 5 from -1.45,1.45 to -0.85,2.05 size 0.18,20 filled lt 1
    set arrow 6 from 1.45,1.45 to 0.85,2.05 size 0.18,20 filled lt 1
    set arrow 7 from 0.68,-1.3 to 1.43,-0.9 size 0.18,20 filled lt 1
    set label 4 'E' at -0.7,2.2 tc lt 1
  } else {
    set object 25 circle at m - 1.45,1.45 size 0.16 fc rgb 'white' fs solid border lc rgb '#0072b2' front
    set object 26 circle at m + 1.45,1.45 size 0.16 fc rgb 'white' fs solid border lc rgb '#0072b2' front
    set object 27 circle at m + 0.68,-1.3 size 0.16 fc rgb 'white' fs solid border lc rgb '#0072b2' front
    set label 25 '·' at m - 1.45,1.45 center tc lt 1 front
    set label 26 '·' at m + 1.45,1.45 center tc lt 1 front
    set label 27 '·' at m + 0.68,-1.3 center tc lt 1 front
    set label 28 'E' at m - 1.2,1.75 tc lt 1
  }
  set label base + 15 'n_i, μ_i' at m - 2.8,0.3
  set label base + 16 'n_t, μ_t' at m - 2.8,-0.35
}
plot NaN
unset arrow
unset label
unset object

# Figure 9.5: a ray at a scatterer.
set output 'ch09_particle.svg'
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-5:5]
set yrange [-1.9:3.6]
set object 1 circle at 0,0 size 1.6 fc rgb '#e0e0e0' fs solid border lc rgb '#606060'
a = 2.3
set arrow 1 from -4.6,1.6*sin(a) to 1.6*cos(a),1.6*sin(a) size 0.25,20 filled lc rgb '#c01818' lw 3
set arrow 2 from 1.6*cos(a),1.6*sin(a) to 1.6*cos(a) + 2.1*cos(2*a - pi),1.6*sin(a) + 2.1*sin(2*a - pi) size 0.25,20 filled lc rgb '#c01818' lw 1.6
set arrow 3 from 0,0 to 3.1*cos(a),3.1*sin(a) size 0.2,20 lc rgb '#606060' dt (4,4)
set label 1 'n' at 3.3*cos(a),3.3*sin(a) center
set label 2 'I' at -3.8,1.5 tc rgb '#c01818'
set label 3 'R I' at 1.6*cos(a) + 2.4*cos(2*a - pi),1.6*sin(a) + 2.5*sin(2*a - pi) center tc rgb '#c01818'
set label 4 '(1 - R) I' at 0.15,-0.4 center
set label 5 'θ' at -1.9,1.45 center
set label 6 'θ' at -1.35,1.9 center
plot NaN
unset arrow
unset label
unset object

# The film: rays as points, the darker the more power they have.
set terminal gif animate delay 8 loop 0 size 480,420 font 'sans-serif,12' background '#ffffff'
set output 'ch09_film.gif'
set xrange [-0.35:1.35]
set yrange [-0.25:1.25]
set object 1 rectangle from 0,0 to 1,1 fs empty border rgb '#a0a0a0' front
set style fill solid 1.0 border rgb '#d0d0d0'
do for [k = 0:48] {
  set label 1 sprintf('c t = %.2f m', k*0.05) at graph 0.03, 0.96
  plot by_depth('scatterers') skip 1 using ($3 < 0.5 ? $1 : NaN):2:4 with circles fc rgb '#f0f0f0' lw 0.3, \
       moment(k) using 3:4:8 with points lc palette pt 7 ps 0.6
}

# Figures 9.14 and 9.15: spheres below the middle by their temperature, rays as long as their irradiance.
lit = sprintf("< paste -d, '%s' '%s' | sort -t, -k3,3g", file('scatterers'), file('temperatures'))
set autoscale
stats file('temperatures') skip 1 using 15 nooutput name 'warm'
set palette defined (0 '#dfe3e8', 0.02 '#f3e3a8', 0.25 '#f0a020', 0.5 '#e05010', 0.75 '#a01010', 1 '#480008')
set style fill solid 1.0 border rgb '#b0b0b0'
set cbrange [300:warm_max]
set xrange [-0.35:1.35]
set yrange [-0.25:1.25]
spheres = 'lit skip 1 using ($3 < 0.5 ? $1 : NaN):2:4:(column(5 + k)) with circles fc palette lw 0.3'
rays = 'moment(2*k) using 3:4:(0.08*$6*$8):(0.08*$7*$8) with vectors nohead lc rgb "#2070c0" lw 1.4, moment(2*k) using 3:4 with points lc rgb "#2070c0" pt 7 ps 0.25'
set terminal gif animate delay 16 loop 0 size 480,420 font 'sans-serif,12' background '#ffffff'
set output 'ch09_heat_film.gif'
do for [k = 0:24] {
  set label 1 sprintf('c t = %.1f D', 0.1*k) at graph 0.03, 0.96
  eval 'plot '.spheres.', '.rays
}

set terminal svg size 640,540 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset object
set xrange [-0.2:1.2]
set yrange [-0.1:1.2]
set border 3
set xtics nomirror out scale 0.6 0.5
set ytics nomirror out scale 0.6 0.5
set cblabel 'temperature [K]' offset 0.5
do for [figure in 'hot hot_mean'] {
  set output 'ch09_'.figure.'.svg'
  set cbrange [300:figure eq 'hot' ? warm_max : warm_mean]
  set cbtics figure eq 'hot' ? 200 : 20
  set multiplot
  do for [panel = 1:4] {
    k = word('2 4 8 14', panel) + 0
    set lmargin at screen panel % 2 == 1 ? 0.13 : 0.475
    set rmargin at screen panel % 2 == 1 ? 0.46 : 0.805
    set tmargin at screen panel < 3 ? 0.99 : 0.56
    set bmargin at screen panel < 3 ? 0.58 : 0.15
    set format x panel < 3 ? '' : '%g'
    set format y panel % 2 == 1 ? '%g' : ''
    if (panel == 1) { set colorbox user origin 0.835,0.15 size 0.025,0.84 } else { unset colorbox }
    if (panel < 3) { unset xlabel } else { set xlabel 'x/D' }
    if (panel % 2 == 1) { set ylabel 'y/D' offset 1 } else { unset ylabel }
    set label 1 sprintf('c t = %.1f D', 0.1*k) at graph 0.03, 0.94 front
    eval 'plot '.spheres.', '.rays
  }
  unset multiplot
}
unset label
unset cblabel
set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1
set format '%g'

# Figures 9.16 to 9.18: means over rays and spheres, over an ensemble.
set grid
set size noratio
set xrange [0:3]
set xtics 0.5
set ytics auto
set key outside top center horizontal
do for [k = 1:2] {
  set output 'ch09_'.word('motion spent', k).'.svg'
  set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
  set multiplot layout 2,1
  set lmargin 10
  unset xlabel
  set autoscale y
  if (k == 1) {
    set ylabel 'mean position of rays/D'
    plot for [j = 0:2] file('history') skip 1 using 1:(column(2 + j)) with lines lt j + 1 title word('x y z', j + 1)
    set xlabel 'c t/D'
    set ylabel 'mean velocity/c'
    set yrange [-0.4:1.1]
    plot for [j = 0:3] file('history') skip 1 using 1:(column(5 + j)) with lines lt (j < 3 ? j + 1 : 7) \
      title word('v_x v_y v_z ||v||', j + 1)
  } else {
    set ylabel 'mean irradiance/I(0)'
    plot for [j = 0:3] file('history') skip 1 using 1:(column(9 + j)) with lines lt (j < 3 ? j + 1 : 7) \
      title word('I_x I_y I_z ||I||', j + 1)
    set xlabel 'c t/D'
    set ylabel 'temperature [K]'
    set logscale y
    set yrange [280:2200]
    set ytics (300, 400, 600, 1000, 1500, 2000)
    plot file('history') skip 1 using 1:14 with lines lt 2 title 'hottest', '' skip 1 using 1:13 with lines lt 1 title 'mean'
    unset logscale
    set ytics auto
  }
  unset multiplot
}
set lmargin -1
set autoscale y
set terminal svg size 640,360 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch09_radiated.svg'
unset key
set ylabel 'mean net radiation [W/m^2]'
plot file('history') skip 1 using 1:15 with lines lt 1

# After the pulse, and in a steady beam.
set terminal svg size 640,440 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'ch09_seconds.svg'
set key outside top center horizontal
set logscale xy
set xrange [1e-3:100]
set yrange [280:2200]
set xtics auto
set format x '10^{%T}'
set ytics (300, 400, 600, 1000, 1500, 2000)
set xlabel 't [s]'
set ylabel 'temperature [K]'
set label 1 'after the pulse' at 2e-3,1750 tc lt 2
set label 2 'in the steady beam' at 3,1330 tc lt 1
plot file('seconds') skip 1 using 1:3 with lines lt 2 title 'hottest', '' skip 1 using 1:5 with lines lt 1 title 'hottest', \
     '' skip 1 using 1:2 with lines lt 2 dt (8,4) title 'mean', '' skip 1 using 1:4 with lines lt 1 dt (8,4) title 'mean'
unset label
unset logscale
set format '%g'
set output 'ch09_depth.svg'
set xrange [0:1]
set xtics 0.2
set ytics auto
set xlabel 'x/D'
set key top right
set yrange [250:*]
plot file('depth') skip 1 using ($2 > 0.25 ? $1 : NaN):3 with points pt 7 ps 0.4 lc rgb '#a0a0a0' title 'beside the beam', \
     '' skip 1 using ($2 <= 0.25 ? $1 : NaN):3 with points lt 1 title 'in the beam', \
     '' skip 1 using 1:4 with lines lt 2 title 'a lone sphere'

# Figure 9.11: the balance of a sphere.
unset tics
unset border
unset xlabel
unset ylabel
unset key
unset grid
set size ratio -1
set output 'ch09_balance.svg'
set terminal svg size 640,430 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-5:5]
set yrange [-2.7:4]
set object 1 circle at 0,0 size 1.6 fc rgb '#f0a020' fs solid border lc rgb '#606060'
set object 2 circle at 0,0 size 2.0 fs empty border lc rgb '#808080' dt (4,4)
set arrow 1 from -4.8,1.6*sin(a) to 1.6*cos(a),1.6*sin(a) size 0.25,20 filled lc rgb '#c01818' lw 3
set arrow 2 from 1.6*cos(a),1.6*sin(a) to 1.6*cos(a) + 2.1*cos(2*a - pi),1.6*sin(a) + 2.1*sin(2*a - pi) size 0.25,20 filled lc rgb '#c01818' lw 1.6
set arrow 3 from 1.6*cos(a),1.6*sin(a) to 0.8*cos(a),0.8*sin(a) size 0.2,20 filled lc rgb '#c01818' lw 2
do for [k = 0:3] {
  b = pi/4 - 0.35*k
  set arrow 10 + k from 1.75*cos(b),1.75*sin(b) to 2.9*cos(b),2.9*sin(b) size 0.2,20 filled lt 2
  b = -2.2 - 0.35*k
  set arrow 20 + k from 1.75*cos(b),1.75*sin(b) to 2.9*cos(b),2.9*sin(b) size 0.2,20 filled lt 1
}
set label 1 'I' at -4.0,1.5 tc rgb '#c01818'
set label 2 'R I' at 1.6*cos(a) + 2.4*cos(2*a - pi),1.6*sin(a) + 2.5*sin(2*a - pi) center tc rgb '#c01818'
set label 3 '(1 - R) I' at -0.05,0.45 center tc rgb '#202020'
set label 4 'm c dθ/dt' at 0,-0.5 center tc rgb '#202020'
set label 5 'B ε a_s (θ^4 - θ_s^4)' at 3.05,0.3 tc lt 2
set label 6 'h_c a_s (θ - θ_o)' at -2.2,-2.4 right tc lt 1
plot NaN
unset arrow
unset label
unset object

# Figure 9.12: a scatterer in the cube that is its own.
set output 'ch09_length_scale.svg'
set terminal svg size 640,340 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-0.6:3.6]
set yrange [-0.35:2.1]
set style fill solid 1.0 border rgb '#707070'
do for [k = 0:3] { set arrow k + 1 from k,0 to k,2 nohead lc rgb '#a0a0a0' dt (4,4) }
do for [k = 0:2] { set arrow 10 + k from 0,k to 3,k nohead lc rgb '#a0a0a0' dt (4,4) }
do for [k = 0:5] { set object k + 1 circle at 0.5 + k % 3 + word('0.07 -0.1 0.05 0 0.1 -0.06', k + 1), 0.5 + k/3 + word('-0.08 0.05 0.1 0 -0.05 0.08', k + 1) size 0.325 fc rgb '#d8e4f0' fs solid border lc rgb '#707070' }
set arrow 20 from 0.5,1.5 to 0.5 + 0.325*cos(0.6),1.5 + 0.325*sin(0.6) size 0.06,20 filled lw 1.4 front
set label 1 'b' at 0.52,1.68 front
set arrow 21 from 0,-0.12 to 1,-0.12 heads size 0.06,20 filled lw 1.2
set label 2 '(V/N_p)^{1/3}' at 0.5,-0.28 center
set label 3 'L = b/(V/N_p)^{1/3}' at 2,-0.28 center
plot NaN
unset arrow
unset label
unset object

# The inverse problem: the map of the cost, and Figure 9.13.
reset
load style
set output 'ch09_map.svg'
set terminal svg size 640,400 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
those(k, c) = column(1) == k ? column(c) : NaN
stats file('map') skip 1 using 1 name 'points' nooutput
edge = sqrt(points_records/2) - 1
wide = (50/1.5)**(0.5/edge)
high = 0.15/edge/2
set style fill solid 1.0 noborder
set multiplot layout 1,2 margins 0.155,0.86,0.2,0.88 spacing 0.04
set colorbox user origin 0.88,0.2 size 0.025,0.68
set logscale xcb
set cbrange [0.01:1]
set xrange [1.5/wide:50*wide]
set yrange [0.25-high:0.4+high]
set xtics (1.5, 3, 6, 12, 25, 50)
set xlabel 'n̂'
unset key
unset grid
do for [k = 2:3] {
  set title k == 2 ? 'I_x and mean temperature' : 'and the forward sum'
  set ylabel (k == 2 ? 'L' : '')
  set format y k == 2 ? '%g' : ''
  if (k == 3) { unset colorbox }
  plot file('map') skip 1 using (those(k, 2)):3:($2/wide):($2*wide):($3-high):($3+high):4 with boxxyerror lc palette, \
       file('lines') skip 1 using ($4 < 0.1 ? those(k, 2) : NaN):3 with lines lw 1.5 lc rgb '#ffffff', \
       file('searches') skip 1 using (those(k, 5)):6 with points pt 7 ps 0.9 lc rgb '#000000', \
       file('searches') skip 1 using (those(k, 5)):6 with points pt 7 ps 0.6 lc rgb '#ffffff', \
       file('twin') skip 1 using 1:2 with points pt 2 ps 2 lw 3 lc rgb '#00e5ff'
}
unset multiplot
reset
load style
set output 'ch09_generations.svg'
set logscale y
set format y '%g'
set xlabel 'generation'
set ylabel 'best cost'
stats file('courses') skip 1 using 2 name 'search' nooutput
one(k, s, c) = column(1) == k && column(2) == s ? column(c) : NaN
plot for [s = 0:search_max] file('courses') skip 1 using (one(2, s, 3)):4 with lines lt 2 dt (6,4) lw 1.2 title s == 0 ? 'two targets' : '', \
     for [s = 0:search_max] file('courses') skip 1 using (one(3, s, 3)):4 with linespoints lt 1 pt 7 ps 0.4 lw 1.2 title s == 0 ? 'three targets' : ''
