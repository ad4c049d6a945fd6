#!/usr/bin/env bash
# Grades a folder of submissions, as Moodle and Canvas pack them, and writes one table of scores.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
  cat <<END
usage: chapters/assignments/grade.sh chNN FOLDER [options]

Grades every submission in FOLDER, or in a zip of that name, by check.sh. Who handed in is told by the names there:

  Name Surname_123456_assignsubmission_file/...   Moodle
  surnamename_12345_67890_file.cpp                Canvas, with _LATE behind the name of who was late
  ID/..., ID.cpp                                  anything else

Writes scores.csv, a row a student, and for each a table to hand back, NAME.txt. Ends with status 0 if all were graded,
1 if some could not be, 2 if none.

  --ids FILE       lines "name,ID": the name as above and the student's ID; without it the name is the ID
  --out FOLDER     where the tables go (default scores_chNN)
  --list           print who is who, and grade nothing
  --seconds N      as for check.sh
  --build FOLDER   as for check.sh
  --help           print this
END
}

refuse() {
  echo "grade.sh: $1" >&2
  exit 2
}

chapter='' folder='' ids='' out='' is_list=false options=()
while (($# > 0)); do
  case $1 in
    --help)
      usage
      exit
      ;;
    --list) is_list=true ;;
    --ids | --out | --seconds | --build)
      [[ -n ${2:-} && $2 != -* ]] || refuse "a value must follow $1, not empty and not beginning with '-', got '${2:-}'"
      case $1 in
        --ids) ids=$2 ;;
        --out) out=$2 ;;
        *) options+=("$1" "$2") ;;
      esac
      shift
      ;;
    -*) refuse "there is no option '$1'; --help lists them" ;;
    *)
      if [[ -z $chapter ]]; then
        chapter=$1
      elif [[ -z $folder ]]; then
        folder=$1
      else
        refuse "one folder is graded at a time, got '$folder' and '$1'"
      fi
      ;;
  esac
  shift
done
headers=("$here/../${chapter:-none}"_*/assignment/*.hpp)
[[ -f ${headers[0]} ]] || refuse "name the assignment by its chapter, such as ch01, got '$chapter'. --help says more"
noun=$(basename "${headers[0]}" .hpp)
[[ -d $folder || -f $folder ]] || refuse "the submissions must be a folder or a zip, got '$folder'"
[[ -z $ids || -f $ids ]] || refuse "--ids must name a file, got '$ids'"
out=${out:-scores_$chapter}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [[ -f $folder ]]; then
  mkdir "$scratch/unpacked"
  zip=$(cd "$(dirname "$folder")" && pwd)/$(basename "$folder")
  (cd "$scratch/unpacked" && cmake -E tar xf "$zip") || refuse "$folder cannot be unpacked: give a zip, or a folder"
  folder=$scratch/unpacked
fi

# A line a source: key (one a student), name, whether late, file; who handed in none has a line without a file. Parted by
# what is no blank, so that empty fields stay.
part=$'\x1f'
sources() {
  local path entry key name late
  for path in "$folder"/*; do
    entry=$(basename "$path") late=''
    if [[ $entry =~ ^(.+)_([0-9]+)_assignsubmission_[a-z]+(_.*)?$ ]]; then
      name=${BASH_REMATCH[1]} key=${BASH_REMATCH[1]}_${BASH_REMATCH[2]}
    elif [[ $entry =~ ^([^_]+)(_(LATE|late))?_([0-9]+)_[0-9]+_.+$ ]]; then
      name=${BASH_REMATCH[1]} key=${BASH_REMATCH[1]}_${BASH_REMATCH[4]}
      if [[ -n ${BASH_REMATCH[2]} ]]; then late=late; fi
    elif [[ -d $path || $entry == *.cpp ]]; then
      name=${entry%.cpp} key=$name
    else
      continue
    fi
    {
      find "$path" -type f -name '*.cpp' -not -path '*/__MACOSX/*'
      echo
    } | while IFS= read -r file; do echo "$key$part$name$part$late$part$file"; done
  done
}

# id_of <name>: from the file of IDs, or the name itself.
id_of() {
  if [[ -z $ids ]]; then
    echo "$1"
    return
  fi
  name=$1 awk '
    { gsub(/\r|"/, "") }
    match($0, /,[^,]*$/) && substr($0, 1, RSTART - 1) == ENVIRON["name"] { print substr($0, RSTART + 1); exit }' "$ids"
}

# quoted <text>: as a field of the table.
quoted() { printf '"%s"' "${1//\"/\"\"}"; }

# scores <json> <1, 2 or 3>: the names, the points or the possible points of the lines that have any.
scores() {
  sed -n 's/^    {"name": "\([^"]*\)", "score": \([^,]*\), "max_score": \([^,]*\),.*/\1\n\2\n\3/p' "$1" |
    awk -v which="$2" '{ field[NR % 3] = $0 } NR % 3 == 0 && field[0] > 0 { print field[which % 3] }'
}

# source_of <key>: sets name, late, file and note from the list of sources.
source_of() {
  local found who is_late path files=() fitting=()
  name='' late='' file='' note=''
  while IFS=$part read -r found who is_late path; do
    [[ $found == "$1" ]] || continue
    name=$who
    if [[ -n $is_late ]]; then late=$is_late; fi
    if [[ -n $path ]]; then files+=("$path"); fi
    if [[ $(basename "$path") =~ (^|_)"$noun"(-[0-9]+)?\.cpp$ ]]; then fitting+=("$path"); fi
  done <"$scratch/sources"
  if ((${#fitting[@]} == 1)); then
    file=${fitting[0]}
  elif ((${#files[@]} == 1)); then
    file=${files[0]}
  elif ((${#files[@]} == 0)); then
    note="no source"
  else
    note="${#files[@]} sources, of which one must be $noun.cpp"
  fi
}

# compare <key> <file>: prints whose source is the same but for blanks, if there is one.
compare() {
  local sum
  sum=$(tr -d '[:space:]' <"$2" | cksum)
  awk -v sum="$sum " 'index($0, sum) == 1 { print substr($0, length(sum) + 1); exit }' "$scratch/sums"
  echo "$sum $1" >>"$scratch/sums"
}

sources | sort >"$scratch/sources"
cut -d "$part" -f 1 "$scratch/sources" | uniq >"$scratch/keys"
[[ -s $scratch/keys ]] || refuse "$folder must hold submissions, and holds none with the names that --help lists"
$is_list || mkdir -p "$out" || refuse "$out cannot be made: name another folder with --out"
: >"$scratch/rows"
: >"$scratch/sums"
names=() graded=0 all=0
while IFS= read -r key <&3; do
  all=$((all + 1))
  source_of "$key"
  id=$(id_of "$name")
  if [[ -z $id ]]; then
    file='' note="no ID in $ids"
  elif [[ -n $file ]]; then
    same=$(compare "$key" "$file")
    if [[ -n $same ]]; then note="the same as $same"; fi
  fi
  if $is_list; then
    echo "$name: ID ${id:-unknown}${late:+, $late}${note:+, $note}${file:+, ${file#"$folder"/}}"
    continue
  fi
  points='' variant='' row='' status=2
  if [[ -n $file ]]; then
    status=0
    "$here/check.sh" "$chapter" "$file" --student "$id" --json "$out/$key.json" ${options[@]+"${options[@]}"} \
      >"$out/$key.txt" 2>&1 </dev/null || status=$?
    if ((status > 1)); then note="not graded, $key.txt says why${note:+; $note}"; fi
  fi
  if ((status <= 1)); then
    graded=$((graded + 1))
    mapfile -t names < <(scores "$out/$key.json" 1)
    mapfile -t reached < <(scores "$out/$key.json" 2)
    row=$(printf ',%s' "${reached[@]}")
    points=$(scores "$out/$key.json" 2 | awk '{ sum += $1 } END { print sum }')
    variant=$(sed -n 's/^student .*, variant \([0-9]*\): .*/\1/p' "$out/$key.txt" | head -n 1)
    if grep -q '"name": "compiles",.*"status": "failed"' "$out/$key.json"; then
      note="does not compile${note:+; $note}"
    fi
  fi
  printf '%4s  %s%s\n' "${points:--}" "$name" "${late:+, $late}${note:+: $note}"
  printf '%s,%s,%s,%s,%s,%s%s\n' "$(quoted "$name")" "$(quoted "$id")" "$variant" "$late" "$(quoted "$note")" \
    "$points" "$row" >>"$scratch/rows"
done 3<"$scratch/keys"
if $is_list; then exit; fi
{
  printf 'name,ID,variant,late,note,points'
  for line in ${names[@]+"${names[@]}"}; do printf ',%s' "$(quoted "$line")"; done
  printf '\n'
  cat "$scratch/rows"
} >"$out/scores.csv"
echo "$graded of $all graded, see $out/scores.csv"
((graded > 0)) || exit 2
((graded == all)) || exit 1
