#!/usr/bin/awk -f
# The equations of the monograph, where the library holds them: @equation{M 1.33} in a header's doc comment.
#
#   awk -f docs/equations.awk [-v chapters="ch01_slug ..."] lib/particulate/*/*.hpp
#                                                        writes the equation index, a page, to standard output
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
  split("1.4 2.2 3.4 5.1 7.2 7.3 8.2 8.4 9.3 9.5 A.1 A.2 A.4 A.5 A.6 A.7 A.8 B.1 B.2 B.3", list, " ")  # sections that a derivation starts from, though equations have numbers like theirs
  for (k in list) section["D " list[k]] = 1
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

# "M 1.33" as the reader sees it: "M (1.33)", "M about (1.26)" where the number is inferred, "M section 1.4.1".
function is_section(what) { return what ~ /^R/ || (what in section) || what ~ /^. [1-9AB][0-9]*\.[0-9]+\.[0-9]+$/ }

function shown(what) {
  if (is_section(what)) sub(/ /, " section ", what)
  else {
    if (inferred(what)) sub(/ /, " about ", what)
    sub(/[1-9AB][0-9]*\..*/, "(&)", what)
  }
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
  pending = declaration = comment = ""; depth = 0; parens = 0
}

/^[ \t]*\/\/\/[^<]/ || /^[ \t]*\/\/\/$/ {
  if ($0 ~ /[@\\]equation\{/) { what = equation_in($0); pending = pending what "|" }
  line = $0; sub(/^[ \t]*\/\/\//, "", line); comment = comment line
  next
}
/^[ \t]*(#|\/\/|$)/ { next }

{
  code = $0; trailing = ""
  if (match(code, /\/\/\/</)) { trailing = substr(code, RSTART); code = substr(code, 1, RSTART - 1) }
  sub(/\/\/.*/, "", code); gsub(/"([^"\\]|\\.)*"/, "\"\"", code)
  if (trailing ~ /[@\\]equation\{/) { what = equation_in(trailing); pending = pending what "|"; comment = trailing }
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
      comment = ""
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

# The first formula of a comment that stands on a line of its own, or else the first that says what equals what, as a
# cell of a table can hold it.
function formula_of(text, from, to, parts, n, k) {
  from = index(text, "\\f["); to = index(text, "\\f]")
  if (from) text = substr(text, from + 3, to - from - 3)
  else {
    n = split(text, parts, /\\f\$/)
    for (k = 2; k <= n && parts[k] !~ /=/; k += 2) continue
    if (k > n) return ""
    text = parts[k] " "
  }
  gsub(/[ \t]+/, " ", text); sub(/^ /, "", text); sub(/[,.;]? $/, "", text)
  gsub(/\\\|/, "\\Vert ", text); gsub(/\|/, "\\vert ", text)
n = split(text, parts, / ?\\qquad ?(\\text\{and\} ?\\qquad)?/)
  for (k = 2; k <= n; ++k) parts[1] = parts[1] " \\\\ & " parts[k]
  return "\\f$ \\begin{aligned} & " parts[1] " \\end{aligned} \\f$"
}

# The first sentence, for what has no formula.
function words_of(text) {
  sub(/^(\/\/\/<)? /, "", text); sub(/ *[@\\][a-z].*/, "", text); sub(/\. .*/, "", text); gsub(/\|/, "", text)
  return text
}

# A declaration is complete: it takes the equations that were waiting for it.
function settle(name, path, d, n, list, k) {
  if (pending == "") return
  name = declared_name(declaration)
  if (name == "") stop("@equation stands above something that has no name: " declaration)
  for (d = 1; d <= depth; ++d) if (scope[d] != "") path = path scope[d] "::"
  n = split(pending, list, "|")
  for (k = 1; k < n; ++k) {
    ++rows; number[rows] = list[k]; name_of[rows] = path name; formula[rows] = formula_of(comment); words[rows] = words_of(comment); key[rows] = order(list[k])
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

# Sorts by chapter, equations before sections, then number by number; within one number M before D before R.
function order(what, parts, n) {
  n = split(substr(what, 3), parts, /[.-]/)
  if (parts[1] == "A") parts[1] = 101
  if (parts[1] == "B") parts[1] = 102
  return sprintf("%04d.%d.%04d.%04d.%d", parts[1], is_section(what), parts[2], n > 2 && what !~ /-/ ? parts[3] : 0,
                 index("MDR", substr(what, 1, 1)))
}

function short_name(path) { sub(/^particulate::/, "", path); return path }

function chapter_of(what) { sub(/^. /, "", what); sub(/\..*/, "", what); return what }

# A heading, with the chapter's program if there is one and its place in the map.
function heading(chapter, number, list, n, k, program) {
  number = sprintf(chapter ~ /[AB]/ ? "app%s_" : "ch%02d_", chapter)
  n = split(chapters, list, " ")
  for (k = 1; k <= n; ++k) if (index(list[k], number) == 1) program = sprintf("The program: @ref %s. ", list[k])
  printf "\n## %s %s {#equations_%s}\n\n", chapter ~ /[AB]/ ? "Appendix" : "Chapter", chapter, chapter
  printf "%sAll of its sections: @ref map_%s_%s \"map\".\n\n", program, chapter ~ /[AB]/ ? "appendix" : "chapter", tolower(chapter)
  print "| Number | Formula | Where |\n| :--- | :--- | :--- |"
}

# Functions that share a number and its formula share a line; those that give none of their own stand with the first.
function table(i, k, n, line, where, seen, chapter, link) {
  for (i = 1; i <= rows; i = k) {
    if (chapter_of(number[i]) != chapter) heading(chapter = chapter_of(number[i]))
    n = 0; split("", line); split("", where); split("", seen)
    for (k = i; k <= rows && number[k] == number[i]; ++k)
      if (formula[k] != "" && !(formula[k] in where)) { line[++n] = formula[k]; where[formula[k]] = "" }
    if (n == 0) line[++n] = words[i]
    for (k = i; k <= rows && number[k] == number[i]; ++k) {
      link = sprintf("@ref %s \"%s\"", name_of[k], short_name(name_of[k]))
      if (formula[k] == "") formula[k] = line[1]
      if (!((formula[k] link) in seen)) where[formula[k]] = where[formula[k]] (where[formula[k]] == "" ? "" : ", ") link
      seen[formula[k] link] = 1
    }
    for (k = 1; k <= n; ++k) printf "| %s | %s | %s |\n", shown(number[i]), line[k], where[line[k]]
    for (k = i; k <= rows && number[k] == number[i]; ++k) continue
  }
}

function swap(values, i, j, held) { held = values[i]; values[i] = values[j]; values[j] = held }

END {
  nothing_waits()
  if (filter || failed) exit failed ? 2 : 0
  if (rows == 0) { print "equations: no @equation{...} in any header given" > "/dev/stderr"; exit 2 }
  for (i = 2; i <= rows; ++i)
    for (j = i; j > 1 && key[j - 1] > key[j]; --j) {
      swap(key, j - 1, j); swap(number, j - 1, j); swap(name_of, j - 1, j); swap(formula, j - 1, j); swap(words, j - 1, j)
    }
  print "# Equation index {#equation_index}\n"
  print "Every numbered statement of the monograph that the library holds, in the order of the numbers, with the formula as the"
  print "function that holds it gives it. A number in brackets is that of an equation, any other that of a section. The letter"
  print "says where the formula comes from: **M** is stated in the monograph, **D** derived here from that equation or section,"
  print "**R** reconstructed (@ref provenance). *About* marks a number that we could not read and infer from the order.\n"
  table()
}
