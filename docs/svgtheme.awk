#!/usr/bin/awk -f
# Gnuplot's SVG files, made to follow the reader's colour scheme: transparent ground, ink that flips. Gnuplot draws a
# circle as a polygon of a hundred corners; here it becomes one again, a tenth of the bytes, and smooth.
# awk -v out=DIR -f svgtheme.awk raw/*.svg   writes DIR/<same name> for each.
function finish() { if (name) { if (!styled) fail("no <desc> line: not an SVG that gnuplot finished"); close(name) } }
function fail(why) { print last ": svgtheme: " why > "/dev/stderr"; failed = 1; exit 2 }
BEGIN { if (out == "") { print "svgtheme: set -v out=DIR, the folder to write to" > "/dev/stderr"; failed = 1; exit 2 } }
FNR == 1 { finish(); shape = ""; last = FILENAME; name = FILENAME; sub(/.*\//, "", name); name = out "/" name; styled = 0 }
{ gsub(/rgb\( *0, *0, *0\)/, "black"); gsub(/rgb\(190, 190, 190\)/, "gray") }
/<desc>/ && !styled {
  styled = 1
  print "<style>" > name
  print ":root{color-scheme:light dark}" > name
  print "@media (prefers-color-scheme:dark){" > name
  print " [color=\"black\"]{color:#d7d7d7} [stroke=\"black\"]{stroke:#d7d7d7} [fill=\"black\"]{fill:#d7d7d7}" > name
  print " [color=\"gray\"]{color:#50545c} [stroke=\"gray\"]{stroke:#50545c} [fill=\"gray\"]{fill:#9aa0a8}" > name
  print "}</style>" > name
}
/<rect x="0" y="0" .*fill="#ffffff"\/>/ { sub(/fill="#ffffff"/, "fill=\"none\"") }

# A polygon or path whose corners, forty at least, lie on a circle to a tenth of a pixel.
function round(shape, n, k, corner, xy, x, y, left, right, top, bottom, r, ink) {
  match(shape, /(points = |d=)'[^']*'/)
  corner[0] = substr(shape, RSTART, RLENGTH); gsub(/[^0-9., ]/, "", corner[0])
  n = split(corner[0], corner, " ")
  for (k = 1; k <= n; ++k) {
    split(corner[k], xy, ","); x[k] = xy[1] + 0; y[k] = xy[2] + 0
    if (k == 1 || x[k] < left) left = x[k]
    if (k == 1 || x[k] > right) right = x[k]
    if (k == 1 || y[k] < top) top = y[k]
    if (k == 1 || y[k] > bottom) bottom = y[k]
  }
  r = (right - left)/2
  if (n < 40) return shape
  for (k = 1; k <= n; ++k)
    if (((x[k] - left - r)^2 + (y[k] - top - (bottom - top)/2)^2 - r*r)^2 > (0.2*r)^2) return shape
  match(shape, /(fill = |stroke=)'[^']*'/); ink = substr(shape, RSTART, RLENGTH); sub(/ = /, "=", ink)
  if (ink ~ /^stroke/) ink = "fill='none' " ink
  return sprintf("<circle cx='%.2f' cy='%.2f' r='%.2f' shape-rendering='auto' %s/>", left + r, top + (bottom - top)/2, r, ink)
}
# A path shares its last line with what comes next.
shape != "" || /<(polygon fill|path stroke)/ {
  shape = shape $0 (/'\/>/ ? "" : "\n")
  if (!/'\/>/) next
  match(shape, /<(polygon fill|path stroke)[^>]*'\/>/)
  before = substr(shape, 1, RSTART - 1); after = substr(shape, RSTART + RLENGTH)
  $0 = before round(substr(shape, RSTART, RLENGTH)) after
  shape = ""
}
{ print > name }
END { if (!failed) finish() }
