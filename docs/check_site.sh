#!/usr/bin/env bash
# check_site.sh <html folder> [page.html]...   opens pages of the site in headless Chromium and says what is wrong
# check_site.sh --self-test <html folder>      plants faults into a copy; each must be found
#
# Without pages it takes the start, the guides and indexes, then chapters, briefs, verification and the topics of the
# library, 60 at most.
# Found: formulas not typeset or in error, references to no formula, dead links, anchors, images and objects, anything
# loaded from beyond the disk, commands that nobody expanded; and, in windows 420 and 1280 px wide, pages that scroll
# sideways, what is cut off, covered or out of line, figures that cannot be read, lists that begin again (check_site.js).
# Exit status: 0 nothing found, 1 something found, 2 the check could not be made.
set -euo pipefail

most_pages=60
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

stop() {
  echo "check_site: $*" >&2
  exit 2
}

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  stop "needs Chromium to open the pages; install the package chromium"

# Opens all pages in one browser, and leaves of each the document as it stands after every script has run in
# <page>.dom, and in faults.tsv what cannot be seen. The profile is new, the network log shows what was asked for, and
# nothing is answered.
open_pages() {
  { printf '<!DOCTYPE html><meta charset="utf-8"><pre id="said"></pre><script>const site = "file://%s", pages = [' "$site"
    printf '"%s",' "$@"
    printf '];</script><script>\n' && cat "$here/check_site.js" && printf '</script>\n'; } >"$work/open.html"
  timeout 600 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-sync \
    --disable-background-networking --disable-component-update --disable-default-apps --disable-extensions \
    --disable-web-security --allow-file-access-from-files --hide-scrollbars --window-size=1400,900 \
    --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$work/profile" --log-net-log="$work/net.json" \
    --virtual-time-budget=$((30000 * $#)) --dump-dom "file://$work/open.html" >"$work/said" 2>"$work/chatter" ||
    { cat "$work/chatter" >&2; stop "Chromium could not open the pages"; }
  sed 's/^.*<pre id="said">//; s/&amp;/\&/g; s/&lt;/</g; s/&gt;/>/g' "$work/said" >"$work/lines"
  grep '^fault' "$work/lines" >"$work/faults.tsv" || true
  local page document
  while IFS=$'\t' read -r _ page document; do
    base64 -d <<<"$document" >"$work/$page.dom"
  done < <(grep '^page' "$work/lines")
  for page in "$@"; do
    grep -q '</html>' "$work/$page.dom" || stop "Chromium returned no document for $page: $(grep '^broken' "$work/lines" | head -n 1)"
  done
}

found=0
fault() {
  echo "$1: $2"
  found=$((found + 1))
}

# Text a reader sees: without scripts, listings, tags.
seen_text() {
  tr '\n' ' ' <"$1" | sed -E 's/<(script|style|pre|code|title|svg)[ >]/\n&/g; s/<\/(script|style|pre|code|title|svg)>/&\n/g' |
    grep -vE '^<(script|style|pre|code|title|svg)[ >]' | sed -E 's/<div class="(fragment|line)"[^>]*>([^<]|<\/?(a|span)[^>]*>)*//g; s/<[^>]*>/ /g'
}

count() { grep -oE "$1" "$2" | wc -l || true; }

# What Doxygen left as it was written, and what it expanded where it should have been shown.
check_commands() {
  local name=$1 dom=$2 raw commands='ref|subpage|image|htmlinclude|verbinclude|table|figure|animation|equation|parameters|cite'
  while read -r raw; do
    fault "$name" "a command that nobody meant to be read: $raw"
  done < <(grep -oE "(^|[ (])@($commands) .{0,30}|\*\*[A-Za-z].{0,30}|\{#[a-z].{0,30}" "$work/text"
    grep -oE '<code>[^<]*@(htmlinclude|verbinclude|image html) [^<]*' "$dom")
}

check_formulas() {
  local name=$1 dom=$2 wanted made
  wanted=$(count '<script type="math/tex' "$dom")
  made=$(count 'id="MathJax-Element-[0-9]+-Frame"' "$dom")
  formulas=$((formulas + made))
  [ "$wanted" = "$made" ] || fault "$name" "$wanted formulas, $made typeset"
  # In SVG output MathJax draws an error as red text on this yellow, and a missing label as three question marks.
  if grep -qF 'fill="rgb(255, 255, 136)"' "$dom"; then
    fault "$name" "a formula is in error: $(grep -oE 'matrix\(1 0 0 -1 0 0\)">[^<]+</text>' "$dom" | head -n 1 | sed 's/^[^>]*>//; s/<.*//')"
  fi
  if grep -qE '(<use xlink:href="#MJMAIN-3F"[^>]*></use>){3}' "$dom" || grep -qF '???' "$dom"; then
    fault "$name" "a reference to a formula that does not exist (???)"
  fi
  seen_text "$dom" >"$work/text"
  check_commands "$name" "$dom"
  if grep -oE '.{0,30}(\\\(|\\\[|\\begin\{|\\f[][$({]).{0,40}' "$work/text" >"$work/raw"; then
    fault "$name" "TeX that nobody typeset: $(head -n 1 "$work/raw")"
  fi
}

# What the page loads must be a local file; what it links to may be elsewhere in the world. Requests that Chromium makes
# for itself have no origin in its log.
check_loads() {
  local name=$1 dom=$2 bad
  while read -r bad; do
    fault "$name" "loads from beyond the disk: $bad"
  done < <(grep -oiE '<(link|script|img|object|iframe|embed|source|video|audio|image|use)[^>]*>' "$dom" |
    grep -oiE '(src|href|data|srcset)="([a-z]+:)?//[^"]*"' | grep -viE '="(file|data):' | sort -u)
}

check_requests() {
  local bad
  while read -r bad; do
    fault "a page" "asked the network for $bad"
  done < <(grep -E '"url":"(https?|wss?|ftp):' "$work/net.json" | grep -F '"initiator":' | grep -vF '"initiator":"not an origin"' |
    grep -oE '"url":"[^"]*"' | sort -u)
}

# Every local address of the page: page, target file, anchor, separated by tabs.
collect_links() {
  local name=$1 dom=$2
  grep -oE '<[a-zA-Z][^>]*>' "$dom" | grep -oE ' (href|src|data|xlink:href)="[^"]*"' | sed -E 's/^[^"]*"//; s/"$//; s/&amp;/\&/g' |
    sort -u | while read -r address; do
    case $address in
      '' | '#' | javascript:* | mailto:* | data:* | blob:* | *://* | //*) [[ $address == file:* ]] || continue ;;
    esac
    address=${address#file://"$site"/}
    local file=${address%%#*} anchor=
    if [[ $address == *'#'* ]]; then anchor=${address#*#} && printf -v anchor '%b' "${anchor//%/\\x}"; fi
    file=${file%%\?*}
    printf '%s\t%s\t%s\n' "$name" "${file:-$name}" "$anchor"
  done >>"$work/links"
}

check_links() {
  local name file anchor
  while IFS=$'\t' read -r name file anchor; do
    if [ ! -s "$site/$file" ]; then
      fault "$name" "dead link, image or object: $file"
      continue
    fi
    [ -n "$anchor" ] && [[ $file == *.html ]] || continue
    local anchors="$work/anchors.${file//\//_}"
    [ -e "$anchors" ] || grep -oE ' (id|name)="[^"]*"' "$site/$file" | sed -E 's/^[^"]*"//; s/"$//' | sort -u >"$anchors" || true
    # What scripts add is in the document that the browser gave back.
    grep -qxF -- "$anchor" "$anchors" || { [ -e "$work/$file.dom" ] && grep -qF -- "id=\"$anchor\"" "$work/$file.dom"; } ||
      fault "$name" "dead anchor: $file#$anchor"
  done < <(sort -u "$work/links")
  links=$(sort -u "$work/links" | wc -l)
}

check_drawings() {
  local svg
  for svg in "$site"/*.svg; do
    [ -e "$svg" ] || continue
    if ! tail -c 200 "$svg" | grep -q '</svg>'; then fault "${svg##*/}" "is not a whole SVG file"; fi
  done
  while read -r svg; do
    fault "a style sheet" "loads from beyond the disk: $svg"
  done < <(cat "$site"/*.css | grep -oE 'url\(["'\'']?(https?:)?//[^)]*\)' | sort -u)
}

check_pages() {
  local page bad
  formulas=0 links=0
  : >"$work/links"
  for page in "$@"; do [ -s "$site/$page" ] || stop "no such page in $site: $page"; done
  open_pages "$@"
  for page in "$@"; do
    check_formulas "$page" "$work/$page.dom"
    check_loads "$page" "$work/$page.dom"
    collect_links "$page" "$work/$page.dom"
  done
  while IFS=$'\t' read -r _ page bad; do fault "$page" "$bad"; done <"$work/faults.tsv"
  check_requests
  check_links
  check_drawings
  echo "$# pages, $formulas formulas, $links links and images, $found faults"
  [ "$found" = 0 ]
}

default_pages() {
  cd "$site"
  printf '%s\n' index.html chapters.html verification_guide.html equation_index.html map.html notation.html \
    provenance.html errata.html adding.html trust.html speed.html feature_matrix.html teeth.html assignments.html citelist.html
  # shellcheck disable=SC2010
  ls | grep -E '^namespaceparticulate_1_1[a-z]+\.html$|^(verify_|assignment_)?(ch[0-9]{2}|app[A-Z])(_[a-z0-9_]+)?\.html$' | grep -v '_source' || true
}

# --- The check, checked ----------------------------------------------------------------------------------------------

# must_find <words and markup>...: plants every markup at the end of a page's contents, and wants the check to say the
# words of each. Opening a page takes longest, so one page holds several faults, each with words of its own.
must_find() {
  local planted='' report i
  for ((i = 2; i <= $#; i += 2)); do planted+="<p>${!i}</p>"; done
  sed "s|</body>|$(printf '%s' "$planted" | sed 's/[&|\\]/\\&/g')</body>|" "$original/notation.html" >"$site/planted.html"
  if report=$("$0" "$site" planted.html 2>&1); then
    fault "self-test" "passed in spite of $planted"
  fi
  for ((i = 1; i <= $#; i += 2)); do
    if grep -qF -- "${!i}" <<<"$report"; then
      echo "found: ${!i}"
    else
      fault "self-test" "nothing in '$planted' was called '${!i}' but: $report"
    fi
  done
}

self_test() {
  original=$site
  site=$work/site
  cp -r "$original" "$site"
  cp "$original/notation.html" "$site/planted.html"
  "$0" "$site" planted.html || stop "the page to be spoilt has faults of its own"
  must_find 'a formula is in error' '\( \frac{1 \)' \
    'TeX that nobody typeset' '<span class="tex2jax_ignore">\( x \)</span>' \
    'dead link, image or object: nosuch.png' '<img src="nosuch.png">' \
    'dead link, image or object: nosuch.svg' '<object data="nosuch.svg"></object>' \
    'dead link, image or object: nosuch.html' '<a href="nosuch.html">here</a>' \
    'dead anchor: map.html#nosuch' '<a href="map.html#nosuch">here</a>' \
    'loads from beyond the disk' '<script src="https://example.org/x.js"></script>' \
    'asked the network for "url":"http://127.0.0.1:9/quietly"' '<script>fetch("http://127.0.0.1:9/quietly");</script>'
  cat >"$site/planted.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 200"><g font-size="16"><text x="20" y="50">under</text>
<text x="30" y="52">upon</text><text x="600" y="90">beyond</text><text x="20" y="150" font-size="9">tiny</text></g></svg>
SVG
  must_find 'meant to be read: **so' 'a word **so** that stands raw among others' 'scrolls sideways by' '<div style="width: 3000px; height: 1px"></div>' \
    'px of div#hides' '<div id="hides" style="overflow: hidden; width: 9em; white-space: nowrap">only the beginning of this</div>' \
    'at 1280 px cut off' '<div class="scroll"><table><tr><td style="min-width: 2000px">a wide table</td></tr></table></div>' \
    "covered: span 'a number'" '<span>a number</span><span style="margin-left: -9em; background: red">and a box upon it, as wide</span>' \
    'of div#folded' '<details><summary>more</summary><div id="folded" style="overflow: hidden; width: 9em; white-space: nowrap">only the beginning of this</div></details>' \
    "planted.svg: 'upon' lies on 'under'" '<object type="image/svg+xml" data="planted.svg"></object>' \
    "planted.svg: cut off, 'beyond'" '' 'planted.svg: letters of' '' \
    'px out of line: tr' '<table class="markdownTable"><tr><td>a row</td><td><span style="position: relative; top: 5px">low</span></td></tr></table>' \
    "heads run together: th 'joined'" '<table class="markdownTable"><tr><th style="padding: 0">heads</th><th style="padding: 0">joined</th></tr></table>' \
    'px out of line: ul' '<div class="toc"><ul><li style="margin-top: 12px">one</li><li>two</li><li>three</li><li>four</li></ul></div>' \
    'a list begins again at 1' '<ol><li>one</li></ol><pre>x</pre><ol><li>two</li></ol>' \
    'meant to be read: @ref nosuch' '@ref nosuch "such"' \
    'meant to be read: <code>@htmlinclude' '<code>@htmlinclude x.html</code>'
  must_find 'a formula is in error' '\( \nosuchcommand \)' \
    'a reference to a formula that does not exist' '\( \eqref{nosuchlabel} \)'
  rm "$site/mathjax/MathJax.js"
  must_find 'TeX that nobody typeset' 'no MathJax'
  [ "$found" = 0 ]
}

case ${1:-} in
  --self-test)
    [ $# = 2 ] || stop "usage: check_site.sh --self-test <html folder>"
    site=$(cd "$2" && pwd)
    self_test
    ;;
  '' | -*) stop "usage: check_site.sh [--self-test] <html folder> [page.html]..." ;;
  *)
    site=$(cd "$1" && pwd) || stop "no folder $1; build the target docs first"
    shift
    if [ $# = 0 ]; then
      mapfile -t pages < <(default_pages)
      if [ ${#pages[@]} -gt $most_pages ]; then echo "${#pages[@]} pages, of which the first $most_pages are opened"; fi
      set -- "${pages[@]:0:$most_pages}"
    fi
    check_pages "$@"
    ;;
esac
