#!/usr/bin/env bash
# command_line.sh <check.sh> <check> <source with holes, as a program> <chNN> <scratch folder>
# Command lines that are wrong end with status 2 and a sentence, before anything is built or graded.
set -euo pipefail

script=$1 check=$2 stub=$3 chapter=$4 scratch=$5
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

fail() {
  echo "command_line.sh: $1" >&2
  exit 1
}

# refused <text that must be said> <command>...
refused() {
  local says=$1 status=0
  shift
  "$@" >out 2>err || status=$?
  ((status == 2)) || fail "'$*' must end with status 2, ended with $status"
  grep -qF -- "$says" err || fail "'$*' must say '$says', said '$(<err)'"
  ! grep -q 'in all' out || fail "'$*' must grade nothing"
}

grader=("$check" --program "$stub")
for command in "${grader[*]}" "$script $chapter --build $scratch/never"; do
  read -r -a words <<<"$command"
  refused 'name the student' "${words[@]}"
  refused 'name the student' "${words[@]}" --student ' '
  refused 'a value must follow --student' "${words[@]}" --student
  refused "got '--help'" "${words[@]}" --student --help
  refused 'cannot be written' "${words[@]}" --student anna --json "$scratch/none/anna.json"
  refused 'cannot be written' "${words[@]}" --student anna --json "$scratch"
done
refused 'name the student' "${grader[@]}" --student ''
refused 'two words' "${grader[@]}" --student anna --variant=2
refused "--variant must be 1 to 2, got '3'" "${grader[@]}" --student anna --variant 3
! grep -q -- '--seconds' err || fail "what is right must not be refused"
refused "--seconds must be 1 to 600, got 'two'" "${grader[@]}" --student anna --seconds two
! grep -q -- '--variant' err || fail "what is right must not be refused"
for unknown in "${chapter}4" "${chapter%?}" ''; do
  refused "one of: " "$script" "$unknown" --student anna --build "$scratch/never"
  grep -q "$chapter" err || fail "the list of chapters must hold $chapter"
done
[[ ! -e never ]] || fail "nothing may be built for a command line that is wrong"

# One student, however the ID is typed; another one has other numbers.
table() { "${grader[@]}" --student "$1" || true; }
[[ $(table anna) == "$(table ' Anna ')" ]] || fail "capital letters and blanks at the ends of an ID must not matter"
[[ $(table anna) != "$(table 'an na')" ]] || fail "blanks within an ID must matter"
table anna | grep -q '^  yes         compiles$' || fail "the table must say that it compiles"

# A table that is lost, and scores of another submission where none can be made, are not taken for a result.
if [[ -e /dev/full ]]; then refused 'not all that was printed' sh -c '"$@" >/dev/full' sh "${grader[@]}" --student anna; fi
echo '{"score": 20}' >anna.json
refused 'cannot be made' "$script" "$chapter" --student anna --json anna.json --build /dev/null/none
[[ ! -e anna.json ]] || fail "scores of another submission must go before anything is made"

# Without a program no line is asked, and each says so in one line.
echo 'pair.cpp:1:1: error: expected a semicolon' >log
"$check" --log log --student anna >out && fail "what does not compile must not get full marks"
grep -q '^   no         compiles$' out || fail "the table must say that it does not compile"
points=$(sed -n 's/^ *0 of \([0-9]*\) .*(not asked: it does not compile)$/\1/p' out | paste -sd+)
((points == 20)) || fail "each line that is not asked takes one line, 20 points in all, got $points"
