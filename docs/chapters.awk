#!/usr/bin/awk -f
# What the sources of all chapters say about themselves (@page, @brief, @subpage, @figure), gathered so that lists of
# chapters and figures grow by themselves:
#
#   awk -f docs/chapters.awk -v briefs="ch01 .." -v verified="ch01 .." -v out=DIR -v list=FILE chapters/*_*/*.[ch]pp
#       docs/chapters.md.in
#
# writes FILE, the page chapters.md.in with a line about each page; DIR/gallery.html, the first figure of each page; and for each page
# DIR/<page>_onward.html, what comes next. `briefs` are the chapters with an assignment, `verified` those with cases.

function escaped(text) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); gsub(/>/, "\\&gt;", text); return text }
function link(page, text) { return "<a href=\"" page ".html\">" text "</a>" }
function chapter_of(page) { return substr(page, 1, index(page, "_") - 1) }
function has(list, chapter) { return index(" " list " ", " " chapter " ") }

FILENAME ~ /\.in$/ { text[++lines] = $0; next }
{ sub(/^[ \t]+/, "") }
/^\/\/! @page / { page = $3; sub(/^\/\/! @page [^ ]+ /, ""); title[page] = $0; pages[++n] = page }
/^\/\/! @brief / { sub(/^\/\/! @brief /, ""); brief[page] = $0 }
/^\/\/! @(sub)?section / { section = $3 }
/^\/\/! .*@subpage / {
  for (rest = $0; match(rest, /@subpage [a-zA-Z0-9_]+/); rest = substr(rest, RSTART + RLENGTH)) {
    child = substr(rest, RSTART + 9, RLENGTH - 9)
    children[page] = children[page] " " child; parent[child] = page
  }
}
/^\/\/! @figure\{/ && !(page in figure) {
  sub(/^\/\/! @figure\{/, ""); sub(/\}[^}]*$/, "")
  figure[page] = $0; sub(/,.*/, "", figure[page])
  sub(/^[^,]*, */, ""); gsub(/\\,/, ",")
  caption[page] = escaped($0); place[page] = section
}

# The page, then those below it, in the order in which it names them.
function visit(page, below, k, m) {
  if (page in title) order[++visited] = page
  m = split(children[page], below, " ")
  for (k = 1; k <= m; ++k) visit(below[k])
}

function write_list(page, k, chapter, line) {
  for (k = 1; k <= visited; ++k) {
    page = order[k]; chapter = chapter_of(page)
    line = (page in parent ? "  - @ref " : "- @subpage ") page " \"" title[page] "\": " brief[page]
    if (!(page in parent) && has(verified, chapter)) line = line " What it claims is @ref verify_" chapter " \"verified\"."
    if (!(page in parent) && has(briefs, chapter)) line = line " Its @ref assignment_" chapter " \"assignment\" grades itself."
    print line > list
  }
}

function write_gallery(page, k) {
  print "<div class=\"gallery\">" > (out "/gallery.html")
  for (k = 1; k <= visited; ++k) {
    page = order[k]
    if (page in figure)
      printf "<a href=\"%s.html#%s\"><img src=\"%s.svg\" alt=\"%s\"/><b>%s</b> %s</a>\n", page, place[page], figure[page],
             caption[page], escaped(title[page]), caption[page] > (out "/gallery.html")
  }
  print "</div>" > (out "/gallery.html")
}

function write_onward(page, following, chapter, line) {
  chapter = chapter_of(page)
  if (following) line = "<b>Next:</b> " link(following, escaped(title[following])) ". "
  if (has(briefs, chapter)) line = line "<b>Assignment:</b> " link("assignment_" chapter, "one that grades itself") ". "
  if (has(verified, chapter)) line = line "<b>Verified:</b> " link("verify_" chapter, "what is claimed, and against what") ". "
  print "<p class=\"onward\">" line link("chapters", "All chapters") ".</p>" > (out "/" page "_onward.html")
}

END {
  if (out == "" || list == "") { print "chapters: set -v out=DIR and -v list=FILE, where to write to" > "/dev/stderr"; exit 2 }
  for (k = 1; k <= n; ++k) {
    if (!(pages[k] in brief)) { print "chapters: " pages[k] " has no @brief; say in a line what it is about" > "/dev/stderr"; exit 2 }
    if (!(pages[k] in parent)) visit(pages[k])
  }
  for (k = 1; k <= lines; ++k) if (text[k] == "@chapter_list@") write_list(); else print text[k] > list
  write_gallery()
  for (k = 1; k <= visited; ++k) write_onward(order[k], order[k + 1])
}
