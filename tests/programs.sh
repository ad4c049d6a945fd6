#!/usr/bin/env bash
# programs.sh <source tree> <folder of the programs> <chapter program> <scratch folder>
# What every program owes a script: a status other than 0 where its output is lost, and results of one run alone.
set -uo pipefail

root=$1 bin=$2 chapter=$2/$3 scratch=$4
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1
mkfifo pipe
wrong=0

complain() {
  echo "programs.sh: $*" >&2
  wrong=$((wrong + 1))
}

# loses <command>...: it ends with success, but not where nothing takes what it prints.
loses() {
  local status
  "$@" >said 2>&1 || complain "'$*' must end with 0, ended with $?: $(<said)"
  [[ -s said ]] || complain "'$*' must print something"
  "$@" >/dev/full 2>said && complain "'$*' must not end with 0 on a full disk"
  "$@" >&- 2>said && complain "'$*' must not end with 0 where its output is closed"
  # A reader that has gone: by a signal, and where that is ignored by what the program says.
  for trap in '' 'trap "" PIPE;'; do
    bash -c "$trap exec 4<>pipe 3>pipe 4<&-; exec \"\$@\" >&3" gone "$@" 2>said
    status=$?
    ((status != 0)) || complain "'$*' must not end with 0 where its reader has gone (${trap:-the signal as usual})"
  done
}

for program in "$bin"/ch[0-9]* "$bin"/verify_* "$bin/compare_runs"; do loses "$program" --help; done
for program in "$bin"/ch[0-9]* "$bin"/verify_*; do
  "$program" -h | cmp -s - <("$program" --help) || complain "'$program -h' must print what --help does"
  "$program" --version | grep -q "^${program##*/} of particulate, revision " || complain "'$program --version' must say it"
done
for program in "$bin"/verify_*; do loses "$program" --list; done
for script in verification/run.sh tests/run.sh verification/defects/teeth.sh \
  chapters/assignments/{check,grade}.sh; do
  loses "$root/$script" --help
done
for counted in "$bin/feature_cost" "$bin/harness_counted"; do
  loses "$counted"
  loses "$counted" 2
done
# Before the cloud has become one heap.
short=(--quick --duration 0.6)
loses "$chapter" "${short[@]}" --out full

# --- The results of one run --------------------------------------------------------------------------------------------
finished() { [[ -e $1/stamp.json && -e $1/checks.csv && ! -e $1/unfinished.txt ]]; }
# begin <options>...: a run into `mixed` that goes on until it is killed; returns when it has written a table.
begin() {
  touch begun
  "$chapter" --quick --out mixed "$@" >said 2>&1 &
  run=$!
  for _ in {1..200}; do
    [[ mixed/phases.csv -nt begun ]] && return
    sleep 0.05
  done
  complain "the run must write a table soon: $(<said)"
}
endless=(--side 8 --duration 1 --step 1e-5 --e 0.25)

"$chapter" "${short[@]}" --out mixed >said || complain "the first run must end well: $(<said)"
finished mixed || complain "a run that ended must look so: $(ls -A mixed)"
for signal in KILL INT TERM; do
  begin "${endless[@]}"
  "$chapter" "${short[@]}" --out mixed >said 2>&1 && complain "two runs must not write to one folder"
  grep -q 'another is at work there' said || complain "the second run must say why: $(<said)"
  kill -s "$signal" "$run"
  # Non-interactive shells start background jobs with SIGINT ignored.
  [[ $signal != INT ]] || kill -s KILL "$run"
  wait "$run" 2>said && complain "a run that is killed must not end with 0"
  for stale in stamp.json checks.csv; do
    [[ ! -e mixed/$stale ]] || complain "$stale of another run must not stand beside new tables (SIG$signal)"
  done
  grep -qx 'e = 0.25' mixed/parameters.toml || complain "the parameters must be those of the run that wrote the tables"
  "$bin/compare_runs" mixed mixed 2>said >&2 && complain "what reads results must refuse a run that was cut short"
done
"$chapter" "${short[@]}" --out mixed >said || complain "a later run must end well: $(<said)"
finished mixed || complain "a later run must clear up: $(ls -A mixed)"
grep -qx 'e = 0.5' mixed/parameters.toml || complain "a later run must write its parameters"

# --- Two runs compared ---------------------------------------------------------------------------------------------------
"$bin/compare_runs" full mixed >said || complain "equal runs must be the same to the last digit: $(<said)"
grep -qx 'columns that differ: 0' said || complain "equal runs must differ nowhere: $(<said)"
"$chapter" "${short[@]}" --out softer --e 0.45 >said || complain "a run with another restitution must end well: $(<said)"
"$bin/compare_runs" full softer >said && complain "runs with other parameters must differ"
grep -qx '  e: 0.5 -> 0.45' said || complain "the parameter that differs must be named: $(<said)"
grep -qE '^impacts|^phases' said || complain "the tables that differ must be named: $(<said)"

((wrong == 0)) && echo 'every program says when its output is lost, and leaves the results of one run'
