#!/usr/bin/awk -f
# The equations of the monograph, where the library holds them: @equation{M 1.33} in a header's doc comment.
#
#   awk -f docs/equations.awk lib/particulate/*/*.hpp    writes the equation index, a page, to standard output
#   awk -f docs/equations.awk -v filter=1 header.hpp     the header again, line for line, with the provenance spelled out
#
# A function named in the index becomes a @ref: one that Doxygen does not know stops the documentation. So does an
# @equation that is malformed or stands above nothing.

BEGIN {
  word["M"] = "stated in the monograph"; word["D"] = "derived here"; word["R"] = "reconstruction"
  # Numbers that can be read in the copy we have, or follow from a cross-reference; the others follow from their order.
  split("1.12 1.13 1.19 1.28 1.29 1.30 1.33 1.39 1.40 1.41 2.1 2.13 2.15 2.22 2.40 2.42 2.43 2.46 2.47 2.48 2.49 " \
        "3.4 3.5", list, " ")
  for (k in list) legible[list[k]] = 1
  rows = depth = blocks = 0
}

function stop(what) {
  print FILENAME ":" FNR ": equations: " what > "/dev/stderr"
  failed = 1
  exit 2
}

# A number counts as read if it stands in the list above, a range if both its ends do; sections are always certain.
function inferred(what, ends) {
  if (what !~ /^M/ || what ~ /^M [1-9AB][0-9]*\.[0-9]+\.[0-9]+$/) return 0
  split(substr(what, 3), ends, "-")
  return !((ends[1] in legible) && (ends[2] == "" || (ends[2] in legible)))
}

# "M 1.33" as the reader sees it, "M about 1.26" where the number is inferred.
function shown(what) {
  if (inferred(what)) sub(/ /, " about ", what)
  sub(/-/, "\342\200\223", what)
  return what
}

# Returns the argument of the first @equation{...} of the line, refusing what is none; sets rest to what follows it.
function equation_in(line, what) {
  match(line, /[@\\]equation\{[^}]*\}?/)
  what = substr(line, RSTART + 10, RLENGTH - 11)
  rest = substr(line, RSTART + RLENGTH); before = substr(line, 1, RSTART - 1)
  if (what !~ /^[MDR] [1-9AB][0-9]*\.[0-9]+(\.[0-9]+)?(-[1-9AB][0-9]*\.[0-9]+)?$/)
    stop("write @equation{M 1.33}, {D 1.4.3}, {R 2.4.2} or a range {M 1.39-1.41}; given: {" what "}")
  return what
}

filter {
  line = $0
  if (line ~ /[@\\]equation\{/) {
    what = equation_in(line)
    line = before "@equation_row{" shown(what) "," word[substr(what, 1, 1)] "}" rest
  }
  print line
  next
}

# --- The index -------------------------------------------------------------------------------------------------------

FNR == 1 {
  nothing_waits()
  header = FILENAME; sub(/^.*lib\//, "", header)
  pending = declaration = ""; depth = 0; parens = 0
}

/^[ \t]*\/\/\/[^<]/ || /^[ \t]*\/\/\/$/ {
  if ($0 ~ /[@\\]equation\{/) { what = equation_in($0); pending = pending what "|" }
  next
}
/^[ \t]*(#|\/\/|$)/ { next }

{
  code = $0; trailing = ""
  if (match(code, /\/\/\/</)) { trailing = substr(code, RSTART); code = substr(code, 1, RSTART - 1) }
  sub(/\/\/.*/, "", code); gsub(/"([^"\\]|\\.)*"/, "\"\"", code)
  if (trailing ~ /[@\\]equation\{/) { what = equation_in(trailing); pending = pending what "|" }
  scan(code)
}

# Walks through code: remembers the names of the scopes it enters, and what is declared in between.
function scan(code, i, c) {
  for (i = 1; i <= length(code); ++i) {
    c = substr(code, i, 1)
    if (c == "(") ++parens
    if (c == ")") --parens
    if (parens == 0 && (c == "{" || c == ";" || c == "}")) {
      if (c != "}") settle()
      if (c == "{") scope[++depth] = scope_name()
      if (c == "}" && depth > 0) --depth
      declaration = ""
    } else declaration = declaration c
  }
  declaration = declaration " "
}

function scope_name() {
  if (declaration ~ /^ *(inline )?namespace /) return last_word(declaration)
  if (declaration !~ /\(/ && bare(declaration) ~ /^(struct|class|union|enum) /) return declared_name(declaration)
  return ""
}

function last_word(text) { gsub(/[ \t]+$/, "", text); sub(/^.*[ \t]/, "", text); return text }

# The declaration without what stands before it: template <...>, attributes, the usual specifiers.
function bare(text, i, open, c) {
  gsub(/[ \t]+/, " ", text); sub(/^ /, "", text)
  while (text ~ /^(template ?<|\[\[|inline |constexpr |static |const |extern |requires )/) {
    if (text ~ /^template/) {
      open = 0
      for (i = index(text, "<"); i <= length(text); ++i) {
        c = substr(text, i, 1)
        if (c == "<") ++open
        if (c == ">" && --open == 0) break
      }
      text = substr(text, i + 1)
    } else if (text ~ /^\[\[/) text = substr(text, index(text, "]]") + 2)
    else sub(/^[a-z]+ /, "", text)
    sub(/^ /, "", text)
  }
  return text
}

function declared_name(text) {
  text = bare(text)
  if (sub(/^(enum class|enum|struct|class|union|concept|using) (\[\[[^]]*\]\] )?/, "", text)) {
    match(text, /^[A-Za-z_][A-Za-z_0-9]*/)
    return substr(text, 1, RLENGTH)
  }
  if (index(text, "(") && (!index(text, "=") || index(text, "(") < index(text, "="))) sub(/ ?\(.*/, "", text)
  else sub(/ ?[={].*/, "", text)
  return (match(text, /[A-Za-z_][A-Za-z_0-9]* *$/)) ? last_word(substr(text, RSTART)) : ""
}

# A declaration is complete: it takes the equations that were waiting for it.
function settle(name, path, d, n, list, k) {
  if (pending == "") return
  name = declared_name(declaration)
  if (name == "") stop("@equation stands above something that has no name: " declaration)
  for (d = 1; d <= depth; ++d) if (scope[d] != "") path = path scope[d] "::"
  n = split(pending, list, "|")
  for (k = 1; k < n; ++k) {
    ++rows; number[rows] = list[k]; name_of[rows] = path name; header_of[rows] = header; key[rows] = order(list[k])
  }
  pending = ""
}

# At the end of a file nothing may be waiting.
function nothing_waits() {
  if (pending != "" && !failed) {
    print "equations: lib/" header ": @equation stands above nothing" > "/dev/stderr"
    failed = 1
    exit 2
  }
}

# Sorts by chapter, then number by number; within one number M before D before R.
function order(what, parts, n) {
  n = split(substr(what, 3), parts, /[.-]/)
  if (parts[1] == "A") parts[1] = 101
  if (parts[1] == "B") parts[1] = 102
  return sprintf("%04d.%04d.%04d.%d", parts[1], parts[2], n > 2 && what !~ /-/ ? parts[3] : 0,
                 index("MDR", substr(what, 1, 1)))
}

function short_name(path) { sub(/^particulate::/, "", path); return path }

# Overloads, and a struct beside its functions, may share a number: one line each, the same line only once.
function table(i, row, seen) {
  for (i = 1; i <= rows; ++i) {
    row = sprintf("| %s | [%s](@ref provenance) | @ref %s \"%s\" | @ref %s |", shown(number[i]),
                  word[substr(number[i], 1, 1)], name_of[i], short_name(name_of[i]), header_of[i])
    if (!(row in seen)) print row
    seen[row] = 1
  }
}

function swap(values, i, j, held) { held = values[i]; values[i] = values[j]; values[j] = held }

END {
  nothing_waits()
  if (filter || failed) exit failed ? 2 : 0
  if (rows == 0) { print "equations: no @equation{...} in any header given" > "/dev/stderr"; exit 2 }
  for (i = 2; i <= rows; ++i)
    for (j = i; j > 1 && key[j - 1] > key[j]; --j) {
      swap(key, j - 1, j); swap(number, j - 1, j); swap(name_of, j - 1, j); swap(header_of, j - 1, j)
    }
  print "# Equation index {#equation_index}\n"
  print "Every numbered statement of the monograph that the library holds, in the order of the numbers, with the function"
  print "that holds it. The letter says where the formula comes from: M stated, D derived here (with the number or the"
  print "section it starts from), R reconstructed (with its section); \"about\" marks a number that we could not read and infer"
  print "from the order. What that means is told under @ref provenance.\n"
  print "| Number | Provenance | Where | Header |\n| :--- | :--- | :--- | :--- |"
  table()
}
