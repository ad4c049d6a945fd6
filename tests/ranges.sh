#!/usr/bin/env bash
# ranges.sh <chapter program> <scratch folder> [option]...
# Runs the program at both ends of the range of every parameter, and with every choice, as its --help tells them: what is
# claimed must hold there, or the program must refuse with the name of a parameter.
set -uo pipefail

program=$1 scratch=$2
shift 2
options=(--quick "$@")
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1

# A line a parameter: its name, and the values to try; of what is continued below one line is made first.
"$program" --help | awk '
  /^      / { line = line " " $0; next }
  { if (line != "") print line; line = $0 }
  END { print line }' | awk '
  /^Parameters/ { parameters = 1 }
  !parameters || !/^  --/ { next }
  { name = substr($1, 3); gsub(/  +/, " ") }
  $2 == "true|false" { print name, "true", "false"; next }
  match($0, /; must be one of [^(]*/) { values = substr($0, RSTART + 17, RLENGTH - 17); gsub(/,/, "", values); print name, values; next }
  match($0, /; must lie in [[(][^])]*[])]/) {
    range = substr($0, RSTART + 14, RLENGTH - 14)
    if (range ~ /^\[.*\]$/) { gsub(/[][,]/, "", range); print name, range; next }
  }
  $2 != "TEXT" { print name }' >parameters

# attempt <name> <value>: one line, which begins with what is wrong if anything is.
attempt() {
  local name=$1 value=$2 said=$1_$2.txt status verdict='WRONG' option given=()
  for option in "${options[@]}"; do [[ $option == "--$name="* ]] || given+=("$option"); done
  timeout 300 "$program" --out "$1_$2" "${given[@]}" "--$name=$value" >"$said" 2>&1
  status=$?
  if ((status == 0)); then
    verdict='holds'
  elif ((status == 2)) && cut -d' ' -f1 parameters | grep -qwFf - <(cut -d: -f2- "$said"); then
    verdict='refused'
  fi
  echo "$verdict --$name=$value ended with $status: $([[ $verdict == holds ]] || grep -e FAILS -e "^${program##*/}:" "$said")"
}

wrong=$(awk 'NF < 2 { print "--" $1 " must have a range with two ends, so that both can be tried" }' parameters)
# As many at once as there are processors.
while read -r name values; do
  for value in $values; do
    while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n; done
    attempt "$name" "$value" >"$name.$value.verdict" &
  done
done <parameters
wait
cat ./*.verdict >verdicts
wrong+=${wrong:+$'\n'}$(grep '^WRONG' verdicts)
if [[ -n $wrong ]]; then
  printf 'ranges.sh: %s\n' "$wrong" >&2
  exit 1
elif ! grep -q '^holds' verdicts; then
  echo "ranges.sh: $program must have parameters, and run at some of the ends of their ranges" >&2
  exit 1
fi
echo "${program##*/}: $(grep -c '^holds' verdicts) runs at the ends of ranges hold, $(grep -c '^refused' verdicts) are refused"
