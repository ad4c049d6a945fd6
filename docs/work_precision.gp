# One work-precision diagram, drawn twice: error against seconds, error against right-hand sides.
# guide.cpp writes the script that sets the data's names and `load`s this file. Blocks 0 to curves-1 hold
# error, seconds, median, evaluations; block `curves` the failed runs: number, seconds, median, evaluations.
# A method of order p and fixed step costs through * error^(-1/p): there are `slopes` of these.
load style
set logscale xy
set format '10^{%L}'
set xlabel 'largest error'
# Two columns of names, in letters small enough for the longest; the figure grows with their number.
set key outside bottom center horizontal maxcols 2 samplen 2 font ',13' height 1
set xrange [left:right]
set terminal svg size 720,(450 + 20 * ((curves + 2) / 2)) dynamic enhanced font 'sans-serif,15' background '#ffffff' rounded
if (shaded > left) {
  set object 1 rectangle from left, graph 0 to shaded, graph 1 behind fc rgb '#808080' fs transparent solid 0.18 noborder
}
set title noenhanced heading
# Gnuplot makes an iteration at least once, so what may be absent is put together as text.
failed(column) = failures == 0 ? '' : \
  sprintf(", data index curves using (right):%d with points lc rgb '#808080' pt 2 ps 0.9 lw 2 title 'failed'", column).\
  sprintf(", data index curves using (right*(left/right)**(0.01+0.025*$1)):%d:1 with labels right textcolor rgb '#808080' notitle", column)
theory = ''
if (slopes > 0) {
  do for [i = 1:slopes] {
    theory = theory.sprintf(", [from[%d]:to[%d]] through[%d] * x**(-1.0 / slope[%d])", i, i, i, i).\
             " with lines lc rgb '#808080' lw 1.6 dt 3 notitle"
  }
}
points_of(column) = sprintf("for [i = 1:curves] data index i-1 using 1:%d with linespoints ", column).\
  "lc rgb ink[i] pt mark[i] ps 0.8 lw 1.8 dt dash[i] title title[i] noenhanced"
spread = "for [i = 1:curves] data index i-1 using 1:2:(0):($3-$2) with vectors nohead lc rgb ink[i] lw 1.2 notitle, "
set output name.'_seconds.svg'
set ylabel 'seconds'
eval 'plot '.spread.points_of(2).failed(2)
set output name.'_evaluations.svg'
set ylabel 'right-hand sides'
eval 'plot '.points_of(4).theory.failed(4)
set output
reset
