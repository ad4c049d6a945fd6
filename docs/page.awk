#!/usr/bin/awk -f
# A page in plain Markdown, as a code host shows it, made a page of the site, line for line:
#
#   # Title                       gets the label <page>, the name of the file; of a brief, assignment_chNN (the start has
#                                 the label index of its own)
#   ## A section. And more        gets the label <page>_a_section
#   [text](map.md)                links to the page of that file; [text](../chapters/ch01_a/ch01_a.cpp#ch01_b) to the
#                                 label ch01_b, whatever a code host opens instead
#   - [text](map.md)              where a list item begins: likewise, and that page stands below this one
#   [key](references.bib)         cites
#   `laws::At<>`, `verify_ch01_x` link to what the library calls so, and to a case
#   $`x`$                         is a formula
#   <!-- @command -->             is for the site alone
#
# Exit status 2: something that would stand raw on a code host, a link to a file that is not there or over two lines.
# Doxygen would not notice that, a test does, by -v check=1, which prints nothing else.

BEGIN {
  topic = "^(kinematics|schemes|laws|contact|scenes|identification|swarm|thermo|scattering|continuum|fluid|reference|report)::[A-Za-z_]"
  raw = "(^|[^A-Za-z0-9_.\\\\])[@\\\\](f[$[{]|[a-z]+)|[{]#"
}

function stop(what) { print FILENAME ":" FNR ": page: " what > "/dev/stderr"; bad = 1; exit 2 }

# The label of what a link leads to, and of the page that a file is.
function label_of(path) {
  if (sub(/^.*#/, "", path)) return path
  if (match(path, /ch[0-9][0-9][a-z_]*\/assignment\/README\.md$/)) return "assignment_" substr(path, RSTART, 4)
  sub(/^.*\//, "", path); sub(/\.[a-z]+$/, "", path)
  return path
}

function slug_of(heading) {
  sub(/\. .*/, "", heading); heading = tolower(heading)
  gsub(/[^a-z0-9]+/, "_", heading); gsub(/^_|_$/, "", heading)
  return heading
}

# Text between code spans: its links, and what it must not hold.
function prose(text, out, target, file) {
  if (match(text, raw)) stop("a code host would show this raw, write it as plain Markdown: " substr(text, RSTART, 40))
  while (match(text, /\]\([^) ]*\)/)) {
    target = substr(text, RSTART + 2, RLENGTH - 3)
    out = out substr(text, 1, RSTART)
    text = substr(text, RSTART + RLENGTH)
    if (target ~ /:/) { out = out "(" target ")"; continue }
    file = target; sub(/#.*/, "", file)
    if (file != "" && system("test -e '" folder file "'")) stop("a link to a file that is not there: " target)
    if (file == "references.bib" && match(out, /\[[^[]*\]$/)) out = substr(out, 1, RSTART - 1) "@cite " substr(out, RSTART + 1, RLENGTH - 2)
    else out = out "(@ref " label_of(target) ")"
  }
  return out text
}

# A code span: a name of the library, a case, or words in which Doxygen must not see commands.
function code(span, name) {
  name = span
  if (span ~ topic) {
    sub(/(<>|\(\))$/, "", name); sub(/^[a-z]+::/, "", span)
    return "@ref particulate::" name " \"" span "\""
  }
  if (sub(/^verify_(ch[0-9][0-9]|app[A-Z])_/, "", name)) return "@ref " span " \"" name "\""
  if (span !~ /@/) return "`" span "`"
  gsub(/[@<>]/, "\\\\&", span)
  return "<code>" span "</code>"
}

# A line, piece by piece; a span that it leaves open is closed by a later one.
function inline(line, out, k, span) {
  while (k = index(line, "`")) {
    span = substr(line, 1, k - 1)
    line = substr(line, k + 1)
    if (within) out = out span "`"
    else {
      out = out prose(span)
      if (!(k = index(line, "`"))) out = out "`"
      else {
        span = substr(line, 1, k - 1)
        line = substr(line, k + 1)
        if (out ~ /\$$/ && line ~ /^\$/) {
          out = substr(out, 1, length(out) - 1) "\\f$ " span " \\f$"
          line = substr(line, 2)
        } else out = out code(span)
        continue
      }
    }
    within = !within
  }
  return out (within ? line : prose(line))
}

FNR == 1 {
  page = label_of(FILENAME); folder = FILENAME; fenced = within = 0
  if (!sub(/[^\/]*$/, "", folder)) folder = ""
}
/^ *```/ { fenced = !fenced }
fenced || /^ *```/ { if (!check) print; next }
/^$/ { within = 0 }
{
  line = ""; rest = $0
  while (match(rest, /<!-- @[^>]* -->/)) {
    before = substr(rest, 1, RSTART - 1); command = substr(rest, RSTART + 5, RLENGTH - 9)
    rest = substr(rest, RSTART + RLENGTH)
    line = line inline(before) command
  }
  line = line inline(rest)
  if (line ~ /^[^[]*\]\(/) stop("Doxygen loses its way in a link over two lines, write it on one")
  if (line ~ /^- \[[^]]*\]\(@ref [^)]*\)/) {
    match(line, /\]\(@ref /)
    target = substr(line, RSTART + RLENGTH); sub(/\).*/, "", target)
    line = "- @subpage " target " \"" substr(line, 4, RSTART - 4) "\"" substr(line, index(line, ")") + 1)
  }
  if (/^##+ /) line = line " {#" page "_" slug_of($0) "}"
  if (/^# / && page != "index") line = line " {#" page "}"
  if (!check) print line
}
END { exit bad ? 2 : 0 }
