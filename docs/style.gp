# House style of every figure: the SVG terminal, inks that read on white and on near-black, CSV input.
# A chapter's figures.gp begins with `load style`; docs/CMakeLists.txt sets style, data and verification.
# Hues are Okabe and Ito's, darkened or lightened to at least 3:1 contrast on both grounds.
set terminal svg size 640,420 dynamic enhanced font 'sans-serif,16' background '#ffffff' rounded
set datafile separator comma
set linetype 1 lc rgb '#0072b2' lw 2.2 pt 7  ps 0.7 dt 1      # blue, disc
set linetype 2 lc rgb '#d55e00' lw 2.2 pt 5  ps 0.7 dt 1      # vermilion, square
set linetype 3 lc rgb '#009e73' lw 2.2 pt 9  ps 0.8 dt 1      # green, triangle
set linetype 4 lc rgb '#cc79a7' lw 2.2 pt 11 ps 0.8 dt 1      # pink, triangle down
set linetype 5 lc rgb '#b8860b' lw 2.2 pt 13 ps 0.8 dt 1      # ochre, diamond
set linetype 6 lc rgb '#2f93d0' lw 2.2 pt 4  ps 0.8 dt (8,4)  # sky, open square
set linetype 7 lc rgb '#808080' lw 1.4 pt 6  ps 0.8 dt (3,4)  # reference slopes and exact curves
set linetype cycle 6
set border 3 lw 1
set tics nomirror out scale 0.6
set grid xtics ytics lc rgb 'gray' lw 0.6 dt 1
set key bottom left reverse Left samplen 2 spacing 1.15 noopaque nobox
set style fill solid 1.0 noborder
set palette defined (0 '#0d0887', .25 '#7e03a8', .5 '#cc4778', .75 '#f89540', 1 '#f0f921')
