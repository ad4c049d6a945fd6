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
plot file('indices') skip 1 using 1:2:3 with yerrorlines lt 1

# A cell in section, and rays that meet it.
set size ratio -1
set output 'appB_cell.svg'
set xrange [-6:6]
set yrange [-5:5]
set xlabel 'along the axis [μm]'
set ylabel 'across [μm]'
set style fill solid 1.0 noborder
plot file('outline') skip 1 using (-$2):1 with lines lt 2, '' skip 1 using 2:1 with lines lt 2, \
     for [k = 0:5] sprintf("< awk -F, '$1 == %d && NR > 1' '%s'", k, file('section')) using 2:3 with lines lt 1, \
     file('section') skip 1 using (abs($2) < 2 && abs($3) < 3.92 ? $2 : NaN):3:4:5 with vectors size 0.2,20 lc rgb '#808080'

# Rays among cells; a cell of the slice is drawn by its edge-on view.
set output 'appB_progress.svg'
set terminal svg size 640,640 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set xrange [0:1]
set yrange [0:1]
set xtics 0.5
set ytics 0.5
unset xlabel
unset ylabel
set multiplot layout 2,2
do for [t in '0.2 0.5 0.8 1.1'] {
  set label 1 'c t = '.t.' D' at graph 0.03, 1.06
  plot file('slice') skip 1 using ($1 + 0.009*$4):($2 - 0.009*$3):(-0.018*$4):(0.018*$3) with vectors nohead lc rgb '#e0a0a0' lw 2, \
       sprintf("< awk -F, '$1 == %s' '%s'", t, file('moments')) using 2:3:(0.06*$4*$6):(0.06*$5*$6) with vectors nohead lt 1
}
unset multiplot
unset label

# Figure B.8: the local frame.
set output 'appB_frame.svg'
set terminal svg size 640,300 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset tics
unset border
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
set label 5 'θ' at -0.25,0.7
plot NaN notitle
