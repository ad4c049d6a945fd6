#!/usr/bin/env bash
# grade.sh <cmake> <chapters/assignments> <tests/assignments/ch01> <scratch folder> names|scores
# A folder of submissions with names as Moodle and Canvas give them: who is who, and the table of scores.
set -euo pipefail

cmake=$1 scripts=$2 submissions=$3 scratch=$4 part=$5

fail() {
  echo "grade.sh: $1" >&2
  exit 1
}

rm -rf "$scratch"
mkdir -p "$scratch/handed_in"
cd "$scratch"

# hand_in <text> <path>
hand_in() {
  mkdir -p "$(dirname "handed_in/$2")"
  printf '%s\n' "$1" >"handed_in/$2"
}

names() {
  hand_in one "Anna Maria Weiß_123456_assignsubmission_file/pair_law.cpp"
  hand_in two "Bob O_Neil_123457_assignsubmission_file/homework/mine.cpp"
  hand_in - "No Body_123458_assignsubmission_file/pair_law.pdf"
  hand_in three "Two Tries_123459_assignsubmission_file/first.cpp"
  hand_in four "Two Tries_123459_assignsubmission_file/second.cpp"
  hand_in five "With Notes_123460_assignsubmission_file/pair_law.cpp"
  hand_in six "With Notes_123460_assignsubmission_file/notes.cpp"
  hand_in - "With Notes_123460_assignsubmission_onlinetext/onlinetext.html"
  hand_in seven "doejane_12345_67890_pair_law.cpp"
  hand_in '  on e' "latecomer_LATE_12346_67891_pair_law-1.cpp"
  hand_in ten "latecomer_LATE_12346_67892_notes.cpp"
  hand_in eight "carla@school.edu/pair_law.cpp"
  hand_in nine "dora.cpp"
  hand_in - "README.txt"
  sort >expected <<'END'
Anna Maria Weiß: ID Anna Maria Weiß, Anna Maria Weiß_123456_assignsubmission_file/pair_law.cpp
Bob O_Neil: ID Bob O_Neil, Bob O_Neil_123457_assignsubmission_file/homework/mine.cpp
No Body: ID No Body, no source
Two Tries: ID Two Tries, 2 sources, of which one must be pair_law.cpp
With Notes: ID With Notes, With Notes_123460_assignsubmission_file/pair_law.cpp
doejane: ID doejane, doejane_12345_67890_pair_law.cpp
latecomer: ID latecomer, late, the same as Anna Maria Weiß_123456, latecomer_LATE_12346_67891_pair_law-1.cpp
carla@school.edu: ID carla@school.edu, carla@school.edu/pair_law.cpp
dora: ID dora, dora.cpp
END
  "$scripts/grade.sh" ch01 handed_in --list | sort | diff - expected || fail "a folder must be told who is who"
  (cd handed_in && "$cmake" -E tar cf ../handed_in.zip --format=zip ./*)
  "$scripts/grade.sh" ch01 handed_in.zip --list | sort | diff - expected || fail "a zip must be taken as a folder is"

  printf '%s\r\n' 'name,ID' '"Anna Maria Weiß",anna@school.edu' 'doejane,1234567' >ids.csv
  "$scripts/grade.sh" ch01 handed_in --list --ids ids.csv >listed
  grep -q '^Anna Maria Weiß: ID anna@school.edu, ' listed || fail "an ID must be found by a name, got $(<listed)"
  grep -q '^doejane: ID 1234567, ' listed || fail "an ID must be found by a name, got $(<listed)"
  grep -q '^dora: ID unknown, no ID in ids.csv$' listed || fail "a name without an ID must be said, got $(<listed)"
  [[ ! -e scores_ch01 ]] || fail "a list must write nothing"

  mkdir empty
  refused "holds none" ch01 empty
  refused "got 'ch0'" ch0 handed_in
  refused "got 'none'" ch01 none
  refused "got ''" ch01
  refused "got 'none.csv'" ch01 handed_in --ids none.csv
  refused "a value must follow --out" ch01 handed_in --out
  refused "there is no option '--late'" ch01 handed_in --late
}

# refused <text that must be said> <arguments>...
refused() {
  local says=$1 status=0
  shift
  "$scripts/grade.sh" "$@" >out 2>err || status=$?
  if ((status != 2)) || ! grep -qF -- "$says" err; then
    fail "'$*' must end with 2 and say \"$says\", ended with $status: $(<err)"
  fi
}

scores() {
  local right holes=("$scripts"/../ch01_*/assignment/pair_law.cpp)
  right=$(sed '/#pragma once/d' "$submissions/right.hpp" && sed '/right.hpp/d' "$submissions/right_by_hand.cpp")
  # The right one is right in the first variant, which is the one of this ID.
  hand_in "$right" "anna_12345_1_pair_law.cpp"
  hand_in "$(<"${holes[0]}")" "bob_LATE_12346_2_pair_law.cpp"
  hand_in 'double strength(' "Carla, the 2nd_7_assignsubmission_file/pair_law.cpp"
  hand_in - "dora_12348_4_pair_law.pdf"
  status=0
  "$scripts/grade.sh" ch01 handed_in --out out --build build >said || status=$?
  ((status == 1)) || fail "a submission that cannot be graded must end it with 1, got $status: $(<said)"
  grep -q '^3 of 4 graded' said || fail "three of four must be graded: $(<said)"
  head -n 1 out/scores.csv | grep -q '^name,ID,variant,late,note,points,"strength: ' || fail "a head: $(<out/scores.csv)"
  grep -q '^"anna","anna",1,,"",20,2,1,' out/scores.csv || fail "full marks, line by line: $(<out/scores.csv)"
  grep -q '^"bob","bob",[12],late,"",0,0,0,' out/scores.csv || fail "late, and nothing right: $(<out/scores.csv)"
  grep -q '^"Carla, the 2nd","Carla, the 2nd",[12],,"does not compile",0,' out/scores.csv ||
    fail "what does not compile must be said: $(<out/scores.csv)"
  grep -q '^"dora","dora",,,"no source",$' out/scores.csv || fail "who handed in none has a row: $(<out/scores.csv)"
  grep -q '20 of 20 *in all' out/anna_12345.txt || fail "a table to hand back must be kept"
}

"$part"
