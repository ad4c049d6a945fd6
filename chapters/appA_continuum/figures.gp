# Figures of appendix A, from what appA_continuum wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'
line(k) = sprintf("< awk -F, '$1 == %d' '%s'", k, file('lines'))
arrows(k) = sprintf("< awk -F, '$3 == %d' '%s'", k, file('normals'))

set output 'appA_motion.svg'
set terminal svg size 640,440 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set size ratio -1
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
unset grid
plot for [k = 0:9] line(k) using 2:3 with lines lc rgb '#b0b0b0' lw 1, \
     for [k = 10:25] line(k) using 2:3 with lines lc rgb '#b0b0b0' lw 1, \
     for [k = 0:9] line(k) using 4:5 with lines lt 1 lw 1.6, \
     for [k = 10:25] line(k) using 4:5 with lines lt 1 lw 1.6, \
     arrows(1) using 1:2:4:5 with vectors size 0.03,20 filled lt 2 lw 2, \
     arrows(2) using 1:2:4:5 with vectors size 0.03,20 filled lt 3 lw 2
set size noratio
set grid xtics ytics lc rgb 'gray' lw 0.6 dt 1

set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set output 'appA_elements.svg'
set logscale xy 10
set format '10^{%T}'
set xlabel 'size h of the element [m]'
set ylabel 'relative error'
set key top left
plot file('elements') skip 1 using 1:1 with lines lt 7 notitle, \
     '' skip 1 using 1:2 with linespoints lt 1 title 'edge, F dX', \
     '' skip 1 using 1:3 with linespoints lt 2 title 'face, J F^{−T} N dA', \
     '' skip 1 using 1:4 with linespoints lt 3 title 'volume, J dV'
unset logscale
set format

set output 'appA_pressures.svg'
set xlabel 'ρ/ρ_R'
set ylabel 'P/P_R'
set key top left
plot file('pressures') skip 1 using 1:2 with lines lt 1 lw 5 title 'linear', '' skip 1 using 1:3 with lines lt 4 title 'linear, 3 Y', \
     '' skip 1 using 1:4 with lines lt 2 title 'gas at one temperature', '' skip 1 using 1:5 with lines lt 3 title 'gas without heat'

# Figure A.1: a tetrahedron whose faces lie in the planes of the axes, but for one.
set output 'appA_tetrahedron.svg'
set terminal svg size 640,480 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset tics
unset border
unset grid
unset xlabel
unset ylabel
unset key
set size ratio -1
set xrange [-1.35:1.75]
set yrange [-1.05:1.45]
# Corners in the plane of the page: x to the lower left, y to the right, z up.
set object 1 polygon from -0.7,-0.6 to 1.1,0 to 0,1.05 to -0.7,-0.6 fc rgb '#0072b2' fs transparent solid 0.18 border rgb '#0072b2'
set arrow 1 from 0,0 to -1.05,-0.9 size 0.06,20 lc rgb '#808080' dt 2
set arrow 2 from 0,0 to 1.55,0 size 0.06,20 lc rgb '#808080' dt 2
set arrow 3 from 0,0 to 0,1.4 size 0.06,20 lc rgb '#808080' dt 2
set label 1 'x' at -1.12,-0.98 center
set label 2 'y' at 1.65,0 center
set label 3 'z' at 0.1,1.38
set arrow 4 from 0.13,0.15 to 0.55,0.62 size 0.06,20 filled lt 3 lw 2.4
set label 4 'n' at 0.6,0.7
set arrow 5 from 0.13,0.15 to 0.95,0.42 size 0.06,20 filled lt 2 lw 2.4
set label 5 't = σ n' at 1.0,0.46
set label 6 'tractions −σ e_j on the faces across the axes' at 0.2,-0.85 center tc rgb '#606060'
set arrow 7 from 0.35,0.33 to 0.05,0.55 size 0.06,20 lc rgb '#b8860b' lw 2 dt (4,3)
set arrow 8 from -0.25,0.15 to -0.7,0.3 size 0.06,20 lc rgb '#b8860b' lw 2 dt (4,3)
set arrow 9 from 0.13,-0.2 to 0.02,-0.55 size 0.06,20 lc rgb '#b8860b' lw 2 dt (4,3)
set label 7 '−σ e_x' at 0.1,0.62 center tc rgb '#b8860b'
set label 8 '−σ e_y' at -0.75,0.36 right tc rgb '#b8860b'
set label 9 '−σ e_z' at 0.1,-0.6 tc rgb '#b8860b'
plot NaN notitle
