# Figures of appendix B, from what appB_scattering wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
set datafile missing NaN
# The curve of one surface.
curve(mu, n) = sprintf("< awk -F, '$1 == %s && $2 == %s' '%s'", mu, n, file('curves'))
dips(mu) = sprintf("< awk -F, '$1 == %s && $6 > 0' '%s'", mu, file('dips'))
set xlabel 'angle of incidence [degrees]'
set ylabel 'R'
set xrange [0:90]
set yrange [0:1]
set xtics 15
set key outside top center horizontal maxcols 5
hats = '1.5 2 4 10 32'
set output 'appB_reflectance.svg'
plot for [k = 1:5] curve('1', word(hats, k)) using 3:4 with lines lt k title 'n̂ = '.word(hats, k), \
     dips('1') using 6:5 with points pt 7 lc rgb '#606060' notitle
set output 'appB_permeability.svg'
set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set multiplot layout 2,1
do for [mu in '2 10'] {
  set label 1 'μ̂ = '.mu at graph 0.03, 0.92
  plot for [k = 1:5] curve(mu, word(hats, k)) using 3:4 with lines lt k title 'n̂ = '.word(hats, k), \
       dips(mu) using 6:5 with points pt 7 lc rgb '#606060' notitle
}
unset multiplot
unset label
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'appB_polarized.svg'
set key outside top center horizontal maxcols 2
plot for [k = 1:2] curve('1', word('1.5 10', k)) using 3:5 with lines lt k title 'in the plane, n̂ = '.word('1.5 10', k), \
     for [k = 1:2] curve('1', word('1.5 10', k)) using 3:6 with lines lt k dt (5,4) title 'across, n̂ = '.word('1.5 10', k)
set output 'appB_solid.svg'
set key outside top center horizontal maxcols 3
set ylabel 'share of the power'
plot file('solid') skip 1 using 1:2 with lines lt 1 title '|r|^2', '' skip 1 using 1:3 with lines lt 2 title 'W_l', \
     '' skip 1 using 1:4 with lines lt 3 title 'W_s'
set output 'appB_forward.svg'
set autoscale xy
stats file('crossing') skip 1 using 1 name 'cells' nooutput
set xrange [0:2]
set xtics 0.5
set xlabel 'c t/D'
set yrange [0:1]
set ylabel 'I_x/||I(0)||'
set key outside top center horizontal maxcols 4
plot for [k = 1:4] sprintf("< awk -F, '$1 == %d' '%s'", cells_max/2**(4 - k), file('crossing')) using 2:3:4 \
     with yerrorlines lt k title sprintf('%d cells', cells_max/2**(4 - k))
set output 'appB_indices.svg'
unset key
set autoscale xy
set xtics auto
set xlabel 'n̂'
set ylabel 'I_x/||I(0)||, more than at n̂ = 1.01'
set yrange [0:*]
plot file('indices') skip 1 using 1:4:5 with yerrorlines lt 1

# A cell in section, and rays that meet it.
set size ratio -1
set output 'appB_cell.svg'
set xrange [-6:6]
set yrange [-5:5]
set xlabel 'along the axis [μm]'
set ylabel 'across [μm]'
set style fill solid 1.0 noborder
ray(k) = sprintf("< awk -F, '$1 == %d && NR > 1' '%s'", k, file('section'))
set arrow 1 from 0,0 to 0,3.91 size 0.2,20 lw 1.2
set label 1 'R_0' at 0.15,2.2
set arrow 2 from 0,0 to 3.4,0 size 0.2,20 lw 1.2
set label 2 'axis' at 3.5,0
set arrow 3 from -1.283,-2.738 to 1.283,-2.738 heads size 0.15,20 lw 1.2
set label 3 '2z' at 0,-2.3 center
set label 4 'n' at -1.7,-4.6 center tc rgb '#606060'
plot file('outline') skip 1 using (-$2):1 with lines lt 2, '' skip 1 using 2:1 with lines lt 2, \
     for [k = 1:4] ray(k) using 2:3 with lines lt 1, ray(0) using 2:3 with lines lt 3 lw 3, \
     file('section') skip 1 using (abs($2) < 2 && abs($3) < 3.92 ? $2 : NaN):3:4:5 with vectors size 0.2,20 lc rgb '#606060' lw 1.6

unset arrow
unset label

# Rays among cells, both near the plane at half height.
set output 'appB_progress.svg'
set terminal svg size 640,880 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [-0.01:0.64]
set yrange [0.395:0.605]
set xtics 0.2
set ytics ('0.4' 0.4, '0.6' 0.6)
set ylabel 'y/D' offset 1
unset grid
set lmargin at screen 0.14
set rmargin at screen 0.98
set style fill solid 1.0 noborder
set multiplot
do for [k = 1:4] {
  t = word('0.15 0.3 0.45 0.6', k)
  set tmargin at screen 1.195 - 0.23*k
  set bmargin at screen 1.03 - 0.23*k
  set format x k == 4 ? '%g' : ''
  if (k == 4) { set xlabel 'x/D' } else { unset xlabel }
  set label 1 'c t = '.t.' D' at graph 0.01, 1.06
  plot file('slice') skip 1 using 1:3:1:2:($3 - 0.00055):($3 + 0.00055) with boxxyerror fc rgb '#e0a0a0', \
       sprintf("< awk -F, '$1 == %s && $2 > 0.001 && ($4 - 0.5)^2 < 0.0025' '%s'", t, file('moments')) using 2:3:(0.04*$5*$7):(0.04*$6*$7) with vectors size 0.008,20 filled lt 1 lw 1.2, \
       '' using 2:3 with points lt 1 ps 0.3
}
unset multiplot
unset label
set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1

# Figure B.3: the system.
set output 'appB_system.svg'
set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset tics
unset border
unset xlabel
unset ylabel
set xrange [-0.75:1.15]
set yrange [-0.1:1.1]
set object 1 rectangle from 0,0 to 1,1 fs empty border rgb '#606060' lw 1.6 front
do for [k = 0:10] { set arrow k + 1 from -0.55,0.25 + 0.05*k to -0.02,0.25 + 0.05*k size 0.03,20 filled lc rgb '#c01818' lw 1.6 front }
set arrow 20 from -0.62,0.25 to -0.62,0.75 heads size 0.02,20 filled lw 1.2
set label 1 'D/2' at -0.65,0.5 right
set label 2 'beam of rays' at -0.3,0.85 center tc rgb '#c01818'
set label 3 'cells in a cube of edge D' at 0.5,1.06 center
plot file('slice') skip 1 using 1:3:1:2:($3 - 0.00055):($3 + 0.00055) with boxxyerror fc rgb '#c04040'
unset arrow
unset label
unset object

# Figure B.8: the local frame.
set output 'appB_frame.svg'
set terminal svg size 640,300 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset tics
unset border
unset xlabel
unset ylabel
set xrange [-3:3]
set yrange [-0.4:2.4]
set arrow 1 from -3,0 to 3,0 nohead lc rgb '#808080'
set arrow 2 from -1.8,1.8 to 0,0 lt 2
set arrow 3 from 0,0 to 1.8,1.8 lt 2
set arrow 4 from 0,0 to 0,1.6 lt 1
set arrow 5 from 0,0 to 1.6,0 lt 1
set label 1 'n' at 0.08,1.6
set label 2 't' at 1.6,-0.2
set label 3 'd' at -1.9,1.9 right
set label 4 "d'" at 1.9,1.9
set object 1 circle at 0,0 size 0.6 arc [45:135] fs empty border rgb '#606060' nowedge
set label 5 'θ' at -0.33,0.82 center
set label 6 'θ' at 0.33,0.82 center
plot NaN notitle
