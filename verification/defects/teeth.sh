#!/usr/bin/env bash
# Whether the verification has teeth: plants the defects of defects.txt, one at a time, and looks which cases turn red.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
  cat <<END
usage: verification/defects/teeth.sh [options] [FOLDER]

Copies the sources to FOLDER (default: build/defects), proves that every case named in defects.txt is green there, then
changes one line of the library at a time and runs the cases named for it, quick, until all defects have had their turn.
Writes FOLDER/teeth.csv: which cases turned red. Ends with status 1 if a defect is caught by nothing. The sources
themselves are never changed. All defects take about a quarter of an hour of one processor core.

  --only NAME       only this defect; may be repeated
  --record          keep the result in verification/defects/teeth.csv, which the documentation shows
  --check           build nothing: every defect's line stands in its file exactly once, its cases exist, and
                    teeth.csv names every defect, each with a case that caught it
  --table FILE      build nothing: write what was recorded to FILE, for readers, with a column that says whether it
                    still holds
  --defects FILE    another list than defects.txt, with its teeth.csv beside it
  --built BUILD     compile only cases and spoilt sources, and link this build of the unchanged project: a minute saved
                    for a single defect, which must not be in a header
  --jobs N          compile so many sources at once (default: 2)
  --help            print this
END
}

die() {
  echo "teeth.sh: $1" >&2
  exit "${2:-1}"
}
wrong() {
  usage >&2
  die "$1" 2
}

list=$here/defects.txt
folder=$root/build/defects
jobs=2
action=run
record=no
only=()
table=
built=
while [[ $# -gt 0 ]]; do
  case $1 in
    --only | --table | --defects | --built | --jobs)
      if [[ $# -lt 2 || -z $2 || $2 == --* ]]; then wrong "$1 needs a value"; fi
      case $1 in
        --only) only+=("$2") ;;
        --table) action=table table=$2 ;;
        --defects) list=$(realpath "$2") ;;
        --built) built=$(realpath "$2") ;;
        --jobs) jobs=$2 ;;
      esac
      shift
      ;;
    --record) record=yes ;;
    --check) action=check ;;
    --help)
      usage
      exit
      ;;
    -*) wrong "there is no option '$1'" ;;
    *) folder=$1 ;;
  esac
  shift
done
recorded=$(dirname "$list")/teeth.csv

# --- The list --------------------------------------------------------------------------------------------------------

names=()
declare -A kind file what from to cases
read_list() {
  local number=0 line key rest name=
  while IFS= read -r line || [[ -n $line ]]; do
    number=$((number + 1))
    if [[ -z $line || $line == \#* ]]; then continue; fi
    read -r key rest <<<"$line"
    case $key in
      defect)
        name=$rest
        if [[ ! $name =~ ^[a-z0-9_]+$ ]]; then
          die "$list:$number: a defect's name must be lower-case letters, digits and underscores, got '$name'"
        fi
        if [[ -v "kind[$name]" ]]; then die "$list:$number: names of defects must differ, got '$name' twice"; fi
        names+=("$name")
        kind[$name]='' file[$name]='' what[$name]='' from[$name]='' to[$name]='' cases[$name]=''
        ;;
      kind | file | what | from | to | cases)
        if [[ -z $name ]]; then die "$list:$number: '$key' must stand below the 'defect' that it belongs to"; fi
        local -n field=$key
        # shellcheck disable=SC2004 # the arrays are associative
        field[$name]=$rest
        unset -n field
        ;;
      *) die "$list:$number: a line must begin with defect, kind, file, what, from, to or cases, got '$key'" ;;
    esac
  done <"$list"
  if [[ ${#names[@]} -eq 0 ]]; then die "$list: there must be at least one defect, got none"; fi
}

# sources_of <defect>: of its cases, each once, in their order.
sources_of() {
  # shellcheck disable=SC2086 # cases are words
  printf '%s\n' ${cases[$1]} | sed 's/:.*//' | awk '!seen[$0]++'
}

# occurrences <defect>: how often its line stands in its file, indentation apart.
occurrences() {
  line=${from[$1]} awk '{ sub(/^[ \t]+/, "") } $0 == ENVIRON["line"] { ++n } END { print n + 0 }' \
    "$root/lib/particulate/${file[$1]}"
}

# planted <defect>: its file with the defect in it.
planted() {
  line=${from[$1]} instead=${to[$1]} awk '
    {
      bare = $0
      sub(/^[ \t]+/, "", bare)
      if (bare != ENVIRON["line"]) print
      else if (ENVIRON["instead"] != "") print substr($0, 1, length($0) - length(bare)) ENVIRON["instead"]
    }' "$root/lib/particulate/${file[$1]}"
}

# what_is_wrong_with <defect>: nothing, if it can be planted.
what_is_wrong_with() {
  local field count case
  for field in kind file what from cases; do
    local -n given=$field
    if [[ -z ${given[$1]} ]]; then echo "$1: '$field' must be given"; fi
    unset -n given
  done
  if [[ ! -f $root/lib/particulate/${file[$1]} ]]; then
    echo "$1: there must be a file lib/particulate/${file[$1]}, and there is none"
  else
    count=$(occurrences "$1")
    if [[ $count -ne 1 ]]; then
      echo "$1: its line must stand in lib/particulate/${file[$1]} exactly once, but does $count times;" \
        "write it into $list as it is now: ${from[$1]}"
    fi
  fi
  if [[ ${from[$1]} == "${to[$1]}" ]]; then echo "$1: 'to' must differ from 'from'"; fi
  for case in ${cases[$1]}; do
    if [[ ! -f $root/verification/${case%%:*}.cpp ]]; then
      echo "$1: there must be a case verification/${case%%:*}.cpp, and there is none"
    elif [[ $case == *:* ]] && ! grep -q "\"${case#*:}\"" "$root/verification/${case%%:*}.cpp"; then
      echo "$1: there must be a case ${case#*:} in verification/${case%%:*}.cpp, and there is none"
    fi
  done
}

check_list() {
  local name problems
  problems=$(for name in "${names[@]}"; do what_is_wrong_with "$name"; done)
  if [[ -n $problems ]]; then
    echo "$problems" >&2
    die "the list of defects does not fit the sources"
  fi
}

# --- The table -------------------------------------------------------------------------------------------------------

# made_from <defect>: a digest of the spoilt file and of the cases; another one means that the result may be outdated.
made_from() {
  local source
  {
    planted "$1"
    for source in $(sources_of "$1"); do cat "$root/verification/$source.cpp"; done
  } | sha256sum | cut -c 1-16
}

# The recorded lines by defect. The columns from the seventh on are revision, date and digest, never quoted.
declare -A result
recorded_names=()
read_recorded() {
  local line name
  if [[ ! -f $recorded ]]; then return; fi
  while IFS= read -r line; do
    name=${line%%,*}
    if [[ $name != defect ]]; then
      recorded_names+=("$name")
      result[$name]=$line
    fi
  done <"$recorded"
}

quoted() { printf '"%s"' "${1//\"/\"\"}"; }

# keep <defect> <caught by> <rows failed>
keep() {
  local revision
  revision=$(git -C "$root" describe --always --dirty --exclude='*' 2>/dev/null || echo unknown)
  result[$1]=$1,$(quoted "${kind[$1]}"),${file[$1]},$(quoted "${what[$1]}"),$(quoted "$2"),$3
  result[$1]+=,$revision,$(date +%F),$(made_from "$1")
}

# write_results <file>: those that are known, in the order of the list.
write_results() {
  local name
  {
    echo 'defect,kind,file,what,caught by,rows failed,revision,date,made from'
    for name in "${names[@]}"; do
      if [[ -v "result[$name]" ]]; then echo "${result[$name]}"; fi
    done
  } >"$1.part"
  mv "$1.part" "$1"
}

# write_table <file>: what was recorded, for readers, with the date and revision of each run, or that it is outdated.
write_table() {
  local name line digest date revision rows caught state
  {
    echo "what is wrong,kind,file,caught by,rows failed,result of"
    for name in "${names[@]}"; do
      caught='' rows='' state='not run yet'
      if [[ -v "result[$name]" ]]; then
        line=${result[$name]}
        digest=${line##*,} line=${line%,*}
        date=${line##*,} line=${line%,*}
        revision=${line##*,} line=${line%,*}
        rows=${line##*,} line=${line%,*}
        caught=${line##*,\"} caught=${caught%\"}
        state="$date at $revision"
        if [[ $digest != "$(made_from "$name")" ]]; then state="changed since $date, not run again"; fi
      fi
      echo "$(quoted "${what[$name]}"),${kind[$name]},${file[$name]},$(quoted "$caught"),$rows,$(quoted "$state")"
    done
  } >"$1.part"
  mv "$1.part" "$1"
}

check_table() {
  local name outdated=0
  if [[ "${recorded_names[*]}" != "${names[*]}" ]]; then
    diff <(printf '%s\n' "${names[@]}") <(printf '%s\n' "${recorded_names[@]}") >&2 || true
    die "$recorded must name the defects of $list, each once and in their order: run teeth.sh --record"
  fi
  for name in "${names[@]}"; do
    if [[ ${result[$name]} == *',"nothing",'* ]]; then die "$recorded: nothing catches $name: add a case that does"; fi
    if [[ ${result[$name]##*,} != "$(made_from "$name")" ]]; then outdated=$((outdated + 1)); fi
  done
  echo "${#names[@]} defects can be planted, and $recorded says what catches each;" \
    "$outdated of its results are older than the sources"
}

# --- Planting --------------------------------------------------------------------------------------------------------

# copy <from> <to>: only if they differ, and with a new time, so that what was compiled from the other text is redone.
copy() {
  if ! cmp -s "$1" "$2"; then
    mkdir -p "$(dirname "$2")"
    cp "$1" "$2"
  fi
}

copy_sources() {
  local path
  cd "$root"
  while IFS= read -r path; do copy "$path" "$copied/$path"; done < <(
    echo CMakeLists.txt
    find lib verification -type f \( -name '*.[ch]pp' -o -name 'CMakeLists.txt' -o -name '*.cmake' -o -name '*.in' \)
  )
  while IFS= read -r path; do
    if [[ ! -f $path ]]; then rm "$copied/$path"; fi
  done < <(cd "$copied" && find . -type f)
}

configure() {
  local name spoilt=
  if [[ -n $built ]]; then
    for name in "${chosen[@]}"; do
      if [[ ${file[$name]} != *.cpp ]]; then die "$name is in a header, ${file[$name]}: leave out --built"; fi
    done
    spoilt=$(for name in "${chosen[@]}"; do echo "${file[$name]}"; done | sort -u | paste -sd ';')
  fi
  if [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER:-}${CCACHE_DISABLE:-} ]] && command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  cmake -G Ninja -S "$copied/verification/defects" -B "$folder/build" -DCMAKE_CXX_FLAGS="-O1 -DNDEBUG ${CXXFLAGS:-}" \
    -DBUILT="$built" -DSPOILT="$spoilt" >"$folder/configure.log" 2>&1 ||
    die "the copy cannot be configured: see $folder/configure.log"
}

# compile <sources of cases>...
compile() {
  cmake --build "$folder/build" --parallel "$jobs" --target "${@//\//.}" >"$folder/compile.log" 2>&1
}

# prove <source, or one case of it>: its quick run; afterwards `red` holds the names of the cases that failed, and `failed`
# the rows.
longest=300
prove() {
  local status=0 log=$folder/run.log end program=${1%%:*} one=()
  if [[ $1 == *:* ]]; then one=(--case "${1#*:}"); fi
  timeout "$longest" "$folder/build/bin/${program//\//.}" --quick --out "$folder/results" "${one[@]}" >"$log" 2>&1 ||
    status=$?
  red=$(sed -n 's/^FAIL  \([a-z0-9_]*\) .*/\1/p' "$log" | paste -sd ' ')
  failed=$(sed -n 's/^[0-9]* rows, \([0-9]*\) failed$/\1/p' "$log")
  end=$(basename "$1")
  if [[ $status -eq 124 ]]; then
    red="$end (no end after $longest s)" failed=0
  elif [[ $status -gt 1 || -z $failed ]]; then
    red="$end (ended with status $status)" failed=0
  fi
}

prove_unchanged() {
  local name case needed=() sources=() count=0
  mapfile -t needed < <(for name in "${chosen[@]}"; do tr ' ' '\n' <<<"${cases[$name]}"; done | sort -u)
  mapfile -t sources < <(for name in "${chosen[@]}"; do sources_of "$name"; done | sort -u)
  say "compiling ${#sources[@]} files of cases and the unchanged library"
  compile "${sources[@]}" || die "the unchanged library does not compile: see $folder/compile.log"
  for case in "${needed[@]}"; do
    count=$((count + 1))
    say "[$count/${#needed[@]}] $case, unchanged"
    prove "$case"
    if [[ -n $red ]]; then die "$case must be green with the unchanged library, but it is not: see $folder/run.log"; fi
  done
  tell "${#needed[@]} cases or files of them are green with the unchanged library"
}

# try <defect>: afterwards `caught` says what turned red, by chapter, and `rows` in how many rows.
try() {
  local spoilt=$copied/lib/particulate/${file[$1]} case chapter last=''
  caught='' rows=0
  planted "$1" >"$spoilt"
  # shellcheck disable=SC2046 # sources are words
  compile $(sources_of "$1") || die "$1 does not compile, so it proves nothing: see $folder/compile.log"
  for case in ${cases[$1]}; do
    prove "$case"
    if [[ -z $red ]]; then continue; fi
    chapter=${case%%_*}
    if [[ $chapter != "$last" ]]; then caught+="${caught:+; }$chapter: "; else caught+=', '; fi
    caught+=${red// /, }
    rows=$((rows + failed)) last=$chapter
  done
  cp "$root/lib/particulate/${file[$1]}" "$spoilt"
}

# say <text>: what is being done, on a terminal; tell <text>: what was done.
say() { if [[ -t 1 ]]; then printf '\r\033[K%s' "$1"; fi; }
tell() {
  say ''
  echo "$1"
}

run() {
  local name count=0 missed=() started
  mkdir -p "$copied"
  say 'copying and configuring'
  copy_sources
  configure
  prove_unchanged
  for name in "${chosen[@]}"; do
    count=$((count + 1)) started=$SECONDS
    say "[$count/${#chosen[@]}] $name"
    try "$name"
    if [[ -z $caught ]]; then
      missed+=("$name")
      caught=nothing
    fi
    keep "$name" "$caught" "$rows"
    tell "[$count/${#chosen[@]}] $name: $caught, $rows rows, $((SECONDS - started)) s"
    write_results "$folder/teeth.csv"
    if [[ $record == yes ]]; then write_results "$recorded"; fi
  done
  if [[ ${#missed[@]} -gt 0 ]]; then die "caught by nothing: ${missed[*]}"; fi
  echo "Every defect turned a case red: ${#chosen[@]} of ${#chosen[@]}"
}

read_list
for name in "${only[@]}"; do
  if [[ ! -v "kind[$name]" ]]; then die "--only must name a defect of $list, got '$name'"; fi
done
if [[ $action != run || $record == yes ]]; then read_recorded; fi
case $action in
  table) write_table "$table" ;;
  check)
    check_list
    check_table
    ;;
  run)
    check_list
    chosen=("${names[@]}")
    if [[ ${#only[@]} -gt 0 ]]; then chosen=("${only[@]}"); fi
    mkdir -p "$folder"
    folder=$(cd "$folder" && pwd)
    copied=$folder/source
    run
    ;;
esac
