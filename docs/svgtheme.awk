#!/usr/bin/awk -f
# Gnuplot's SVG files, made to follow the reader's colour scheme: transparent ground, ink that flips.
# awk -v out=DIR -f svgtheme.awk raw/*.svg   writes DIR/<same name> for each.
function finish() { if (name) { if (!styled) fail("no <desc> line: not an SVG that gnuplot finished"); close(name) } }
function fail(why) { print last ": svgtheme: " why > "/dev/stderr"; failed = 1; exit 2 }
BEGIN { if (out == "") { print "svgtheme: set -v out=DIR, the folder to write to" > "/dev/stderr"; failed = 1; exit 2 } }
FNR == 1 { finish(); last = FILENAME; name = FILENAME; sub(/.*\//, "", name); name = out "/" name; styled = 0 }
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
{ print > name }
END { if (!failed) finish() }
