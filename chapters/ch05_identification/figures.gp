# Figures of chapter 5, from what ch05_identification wrote into the folder `data`.
load style
file(name) = data.'/'.name.'.csv'

set output 'ch05_history.svg'
set xlabel 'time [s]'
set ylabel 'relative energy [J/kg]'
set xrange [0:*]
set yrange [0:*]
set key bottom right
plot file('history') skip 1 using 1:4 with lines lt 7 lw 2.2 title 'best of the first strings', \
     '' skip 1 using 1:3 with lines lt 1 title 'found', \
     '' skip 1 using 1:2 with points lt 2 title 'true'

# Costs over the binary logarithms of both strengths; each point of the map is a square.
set output 'ch05_landscape.svg'
set terminal svg size 640,390 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
stats file('landscape') skip 1 using 1 name 'duration' nooutput
stats file('landscape') skip 1 using ($1 == duration_min ? 0 : NaN) name 'shorter' nooutput
half = 1/(sqrt(shorter_records) - 1)
bit(c) = log(column(c))/log(2)
of(t, c) = column(1) == t ? column(c) : NaN
set style fill solid 1.0 noborder
set multiplot layout 1,2 margins 0.14,0.84,0.27,0.9 spacing 0.1
set size ratio -1
set colorbox user origin 0.87,0.27 size 0.03,0.63
set xrange [-1-half:1+half]
set yrange [-1-half:1+half]
set xtics ('1/2' -1, '1' 0, '2' 1)
set ytics ('1/2' -1, '1' 0, '2' 1)
set xlabel 'α_1 / true'
set ylabel 'α_2 / true'
set logscale cb
set cbrange [0.01:1]
set format cb '%g'
set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '#808080' fs solid 1.0 noborder
unset grid
unset key
do for [k = 0:1] {
  t = k == 0 ? duration_min : duration_max
  if (k == 1) { unset ylabel; unset colorbox }
  set title sprintf('%g s', t)
  plot file('landscape') skip 1 using (of(t, 4) > 0 ? bit(2) : NaN):(bit(3)):(half):(half):4 with boxxyerror lc palette, \
       file('minima') skip 1 using (of(t, 4) > -1 ? bit(2) : NaN):(bit(3)) with points pt 6 ps 1.2 lw 2.5 lc rgb '#ffffff'
}
unset multiplot
unset object 1
unset title
unset logscale
set size noratio
set grid xtics ytics
set xtics autofreq
set ytics autofreq

# Above by generation, below all by evaluations.
set output 'ch05_generations.svg'
set terminal svg size 640,680 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
variant(k) = word('plain rescaled polished', k)
with(k, c) = strcol(1) eq variant(k) ? column(c) : NaN
set multiplot layout 2,1
set lmargin 11
set ylabel 'cost'
set logscale y
set format y '%g'
set yrange [*:1]
set xlabel 'generation'
set xrange [1:*] noextend
set key top right
plot for [k = 1:2] file('generations') skip 1 using (with(k, 2)):4:6 with filledcurves lt k fs transparent solid 0.18 notitle, \
     for [k = 1:2] file('generations') skip 1 using (with(k, 2)):5 with lines lt k title variant(k), \
     for [k = 1:2] file('generations') skip 1 using (with(k, 2)):7 with lines lt k dt (5,4) lw 1.6 notitle
set format y '10^{%L}'
set xlabel 'evaluations'
set xrange [0:*]
set key bottom right
plot for [k = 1:3] file('generations') skip 1 using (with(k, 3)):4:6 with filledcurves lt k fs transparent solid 0.18 notitle, \
     for [k = 1:3] file('generations') skip 1 using (with(k, 3)):5 with linespoints lt k ps 0.5 title variant(k)
unset multiplot
set lmargin -1

set output 'ch05_profiles.svg'
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
unset logscale
set format '%g'
set xlabel 'held at, over the best value'
set ylabel 'rise of the sum of squares'
set xrange [*:*] extend
set yrange [0:12]
set key top center
name(k) = word('alpha1 d_e', k)
title_of(k) = word('α_1 d_e', k)
profile(k) = "< grep '^".name(k).",' '".file('profiles')."' | sort -t, -k2,2g"
plot 3.841458820694124 with lines lt 7 title '95 per cent', \
     for [k = 1:2] profile(k) using 2:3 with linespoints lt k title title_of(k)
