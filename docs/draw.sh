#!/bin/sh
# draw.sh <script.gp> <folder> [name=value]...
# Runs a gnuplot script in an empty <folder>.raw, with the variables given, and leaves the SVG files that it drew in
# <folder>, in the colours of whoever reads them, and films (GIF) as they are. Fails if gnuplot does, or warns (of data
# it cannot find), or draws nothing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
script=$(realpath "$1")
folder=$2
shift 2
definitions="style='$here/style.gp'; work_precision='$here/work_precision.gp'"
for pair in "$@"; do
  # A run is finished when its stamp is there and its list of what it has written so far is gone.
  case $pair in
    data=* | verification=*)
      run=$(realpath "${pair#*=}")
      pair=${pair%%=*}=$run
      if [ ! -e "$run/stamp.json" ] || [ -e "$run/unfinished.txt" ]; then
        echo "draw.sh: $run must hold the results of a run that ended, and has no stamp; run the program again" >&2
        exit 1
      fi
      ;;
  esac
  definitions="$definitions; ${pair%%=*}='${pair#*=}'"
done
rm -rf "$folder" "$folder.raw"
mkdir -p "$folder" "$folder.raw"
cd "$folder.raw"
gnuplot -e "$definitions" "$script" 2>messages || failed=$?
cat messages >&2
if [ -n "${failed:-}" ] || grep -q 'warning:' messages; then
  echo "draw.sh: gnuplot complains about $script; a figure without all of its data is no figure" >&2
  exit 1
fi
set -- *.svg
if [ ! -e "$1" ]; then
  echo "draw.sh: $script drew no SVG file; set its output to '<chapter>_<name>.svg'" >&2
  exit 1
fi
awk -v out="../${folder##*/}" -f "$here/svgtheme.awk" "$@"
for film in *.gif; do
  if [ -e "$film" ]; then cp "$film" "../${folder##*/}"; fi
done
