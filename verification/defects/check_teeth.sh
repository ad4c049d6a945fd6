#!/usr/bin/env bash
# check_teeth.sh <build>   tries teeth.sh: spoilt lists must be refused, a defect must be caught, a harmless change must
#                          not pass for one. <build> is a build of the project.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
wrong=0

complain() {
  echo "check_teeth: $*" >&2
  wrong=$((wrong + 1))
}
# ends <status> <text> <arguments>...: teeth.sh ends with the status and says the text.
ends() {
  local expected=$1 text=$2 status=0
  shift 2
  "$here/teeth.sh" "$@" >said 2>&1 || status=$?
  [ "$status" = "$expected" ] || complain "teeth.sh $* must end with $expected, but ended with $status: $(cat said)"
  [ -z "$text" ] || grep -qF -- "$text" said || complain "teeth.sh $* must say '$text', but says: $(cat said)"
}

cat >defects.txt <<'H'
defect  logarithm
kind    wrong limit
file    kinematics/central_force.cpp
what    At beta = 1 the potential takes d/d_ref - 1 instead of its logarithm.
from    const double growth = exponent == 0.0 ? logarithm : std::expm1(exponent * logarithm) / exponent;
to      const double growth = exponent == 0.0 ? d / d_ref - 1.0 : std::expm1(exponent * logarithm) / exponent;
cases   ch01_fundamentals/central_force

defect  harmless
kind    none
file    kinematics/central_force.cpp
what    Nothing, "only" a sum that stands the other way round.
from    const double exponent = 1.0 - beta;
to      const double exponent = -beta + 1.0;
cases   ch01_fundamentals/central_force:potential_limit
H
cp defects.txt good.txt

# --- Lists that do not fit -------------------------------------------------------------------------------------------
# spoilt <text> <sed script>: the list, changed like that, is refused with the text.
spoilt() {
  sed "$2" good.txt >defects.txt
  ends 1 "$1" --defects defects.txt --check
  cp good.txt defects.txt
}
spoilt 'logarithm: its line must stand in lib/particulate/kinematics/central_force.cpp exactly once, but does 0 times' \
  '5s/logarithm :/algorithm :/'
braces=$(grep -c '^ *}$' "$here/../../lib/particulate/kinematics/central_force.cpp")
spoilt "exactly once, but does $braces times" '5s/ .*/ }/'
spoilt 'there must be a file lib/particulate/kinematics/nosuch.cpp' '3s/central_force/nosuch/'
spoilt 'there must be a case verification/ch01_fundamentals/nosuch.cpp' 's/central_force$/nosuch/'
spoilt 'there must be a case nosuch in verification/ch01_fundamentals/central_force.cpp' 's/:potential_limit/:nosuch/'
spoilt "logarithm: 'to' must differ from 'from'" '6s/d . d_ref - 1.0/logarithm/'
spoilt "logarithm: 'what' must be given" '4s/ .*//'
spoilt "names of defects must differ, got 'logarithm' twice" 's/harmless/logarithm/'
spoilt "a line must begin with" '2s/kind/sort/'
spoilt "must name the defects of" ''
ends 1 "--only must name a defect" --defects defects.txt --only nosuch
ends 2 "there is no option" --nosuch
ends 1 "in a header" --built "$build" --only reaction_points_along "$work/run"

# --- Results ---------------------------------------------------------------------------------------------------------
ends 1 'caught by nothing: harmless' --defects defects.txt --built "$build" --record "$work/run"
grep -q '^logarithm,.*,"ch01: equilibrium, potential_limit, potential_slope",[1-9]' teeth.csv || complain "it must be caught: $(cat teeth.csv)"
ends 1 'nothing catches harmless' --defects defects.txt --check
# What was recorded before another `to` says nothing about it.
sed -i '6s/- 1.0/- 2.0/' defects.txt
ends 0 '' --defects defects.txt --table table.csv
grep -q '^"At beta = 1 .*,"changed since' table.csv || complain "the first result must be outdated: $(cat table.csv)"
grep -q '^"Nothing, ""only"" .*"nothing",0,"20.* at ' table.csv || complain "the second must hold: $(cat table.csv)"
sed -i 2d teeth.csv
ends 1 'must name the defects of' --defects defects.txt --check
ends 0 '' --defects defects.txt --table table.csv
grep -q '^"At beta = 1 .*,"",,"not run yet"$' table.csv || complain "the first must not have been run: $(cat table.csv)"

[ "$wrong" = 0 ] && echo 'teeth.sh does what it should, and refuses what it should'
