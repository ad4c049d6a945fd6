#!/usr/bin/env bash
# check_generators.sh <guide>   tries what makes the pages on small inputs, good ones and spoilt ones
set -euo pipefail
guide=$(realpath "$1")
docs=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
wrong=0

complain() {
  echo "check_generators: $*" >&2
  wrong=$((wrong + 1))
}
# holds <file> <text>...: each text stands in the file.
holds() {
  local file=$1 text
  shift
  for text in "$@"; do grep -qF -- "$text" "$file" || complain "$file must hold '$text', but is: $(cat "$file")"; done
}
lacks() { if grep -qF -- "$2" "$1"; then complain "$1 must not hold '$2'"; fi; }
# refuses <status> <text> <command>...: it fails with the status and says the text.
refuses() {
  local expected=$1 text=$2 status=0
  shift 2
  "$@" >refusal 2>&1 || status=$?
  [ "$status" = "$expected" ] || complain "'$*' must end with $expected, but ended with $status: $(cat refusal)"
  holds refusal "$text"
}

# --- literate.awk ----------------------------------------------------------------------------------------------------
literate() { awk -f "$docs/literate.awk" "$@"; }
printf '%s\n' '//! @page a A' '' '#include <a>' '' '#include <b>' '' 'int f();' '' '  //! Indented.' '' 'int g();' >good.cpp
literate good.cpp >good.out
printf '%s\n' '//! @page a A' \
  '//! @htmlonly[block]<details><summary>What it includes</summary>@endhtmlonly @code{.cpp}' '//! #include <a>' '//!' \
  '//! #include <b>' '//! @endcode @htmlonly[block]</details>@endhtmlonly @code{.cpp}' '//! int f();' '//! @endcode' \
  '//! Indented.' '//! @code{.cpp}' '//! int g();' '//! @endcode' '//!' '//! @htmlinclude a_onward.html' |
  diff - good.out || complain 'literate.awk must turn blank lines into fences, fold includes, and end with what comes next'
printf '%s\n' '//! @page a A' 'int f();' >bad.cpp
refuses 2 'bad.cpp:2: literate: blank line needed before code' literate bad.cpp
printf '%s\n' '//! @page a A' '' 'int f();' '//! prose' >bad.cpp
refuses 2 'bad.cpp:4: literate: blank line needed before prose' literate bad.cpp
printf '%s\n' 'int f();' >bad.cpp
refuses 2 'literate: blank line needed before code' literate bad.cpp
printf '%s\n' '//! prose' >bad.cpp
refuses 2 'no @page' literate bad.cpp

# --- chapters.awk ----------------------------------------------------------------------------------------------------
chapters() { awk -f "$docs/chapters.awk" -v briefs=ch01 -v verified=ch01 -v out=. -v list=chapters.md "$@"; }
printf '//! %s\n' '@page ch01_b B' '@brief The second.' >ch01_b.cpp
printf '//! %s\n' '@page ch01_a A' '@brief The first.' 'See @subpage ch01_c, @subpage ch01_b.' '@section s S' \
  '@figure{ch01_f, One\, two < three.}' '@figure{ch01_g, Another.}' >ch01_a.cpp
printf '//! %s\n' '@page ch01_c C' '@brief The third.' >ch01_c.cpp
printf '%s\n' before '@chapter_list@' after >chapters.md.in
chapters ch01_*.cpp chapters.md.in
printf '%s\n' before '- @subpage ch01_a "A": The first. What it claims is @ref verify_ch01 "verified". Its @ref assignment_ch01 "assignment" grades itself.' \
  '  - @ref ch01_c "C": The third.' '  - @ref ch01_b "B": The second.' after | diff - chapters.md ||
  complain 'chapters.awk must list pages in the order in which they name one another'
holds gallery.html '<a href="ch01_a.html#s"><img src="ch01_f.svg"' 'One, two &lt; three.'
lacks gallery.html ch01_g
holds ch01_a_onward.html '<a href="ch01_c.html">C</a>' 'assignment_ch01.html' 'verify_ch01.html'
lacks ch01_b_onward.html Next
sed -i 2d ch01_b.cpp
refuses 2 'ch01_b has no @brief' chapters ch01_*.cpp chapters.md.in

# --- page.awk --------------------------------------------------------------------------------------------------------
page() { awk -f "$docs/page.awk" "$@"; }
mkdir -p docs ch01_a/assignment
touch docs/map.md docs/references.bib ch01_a/ch01_a.cpp
printf '%s\n' '# Do it' 'See [the chapter](../ch01_a.cpp).' >ch01_a/assignment/README.md
page ch01_a/assignment/README.md >page.out
printf '%s\n' '# Do it {#assignment_ch01}' 'See [the chapter](@ref ch01_a).' | diff - page.out || complain 'page.awk must make a page of a brief'
cat >docs/a_page.md <<'M'
# A page
<!-- @tableofcontents -->
## Part 1. Its name
- [Map](map.md): [b](../ch01_a/ch01_a.cpp#ch01_b), [brief](../ch01_a/assignment/README.md), [key](references.bib),
  [far](https://example.org/#x) `laws::At<>` and `State{.a,
  .b}`, `verify_ch01_orders` <!-- @ref c --> $`\alpha`$ `@table{a_<b>}` costs $2
```
@ref `laws::At<>` [no link](nosuch.md)
```
M
cat >expected <<'M'
# A page {#a_page}
@tableofcontents
## Part 1. Its name {#a_page_part_1}
- @subpage map "Map": [b](@ref ch01_b), [brief](@ref assignment_ch01), @cite key,
  [far](https://example.org/#x) @ref particulate::laws::At "At<>" and `State{.a,
  .b}`, @ref verify_ch01_orders "orders" @ref c \f$ \alpha \f$ <code>\@table{a_\<b\>}</code> costs $2
```
@ref `laws::At<>` [no link](nosuch.md)
```
M
page docs/a_page.md | diff expected - || complain 'page.awk must turn plain Markdown into what Doxygen reads, line for line'
[ -z "$(page -v check=1 docs/a_page.md)" ] || complain 'page.awk must print nothing where it only checks'
for bad in '@ref map' '# A page {#page}' 'a \f$ b \f$' 'so (@cite key)' '| @subpage map |'; do
  printf '%s\n' '# A page' "$bad" >docs/bad.md
  refuses 2 'docs/bad.md:2: page: a code host would show this raw' page -v check=1 docs/bad.md
done
printf '%s\n' '# A page' '[there](nosuch.md#label)' >docs/bad.md
refuses 2 'a link to a file that is not there: nosuch.md#label' page -v check=1 docs/bad.md
printf '%s\n' 'See [the' 'map](map.md).' >docs/bad.md
refuses 2 'docs/bad.md:2: page: Doxygen loses its way in a link over two lines' page -v check=1 docs/bad.md

# --- equations.awk ---------------------------------------------------------------------------------------------------
equations() { awk -f "$docs/equations.awk" "$@"; }
mkdir -p lib/particulate/topic
cat >lib/particulate/topic/laws.hpp <<'H'
namespace particulate::topic {
/// A law.
///
/// \f[ \|x\| = 2, \qquad y =
///      3. \f]
/// @equation{M 2.15} And why.
struct Law {
  double e = 1.0;  ///< restitution @equation{R 2.4.2}
  /// @equation{D 1.4.3}
  /// @return it
  double at(double x) const { return x * e; }
};
/// @equation{M 2.3}
/// @equation{M 1.39-1.41}
template <class D, class E = Law>
  requires Domain<D>
inline bool add_force(const Law& law,
                      const D& domain);
/// @equation{M 1.33} of \f$ b \f$ and \f$ e = 1 \f$
inline constexpr double ruler = 1.0;
}  // namespace particulate::topic
H
equations -v chapters='ch01_fundamentals' lib/particulate/topic/laws.hpp >page
grep '^| [MDR]' page >index
cat >expected <<'H'
| M (1.33) | \f$ \begin{aligned} & e = 1 \end{aligned} \f$ | @ref particulate::topic::ruler "topic::ruler" |
| M (1.39–1.41) |  | @ref particulate::topic::add_force "topic::add_force" |
| D section 1.4.3 |  | @ref particulate::topic::Law::at "topic::Law::at" |
| M about (2.3) |  | @ref particulate::topic::add_force "topic::add_force" |
| M (2.15) | \f$ \begin{aligned} & \Vert x\Vert  = 2, \\ & y = 3 \end{aligned} \f$ | @ref particulate::topic::Law "topic::Law" |
| R section 2.4.2 | restitution | @ref particulate::topic::Law::e "topic::Law::e" |
H
diff expected index || complain 'equations.awk must list six equations, equations before sections, in the order of their numbers'
holds page '## Chapter 2 {#equations_2}' 'The program: @ref ch01_fundamentals.' '@ref map_chapter_2 "map"'
equations -v filter=1 lib/particulate/topic/laws.hpp >filtered
holds filtered '/// @equation_row{M (2.15),stated in the monograph} And why.' '@equation_row{M about (2.3),stated'
[ "$(wc -l <filtered)" = "$(wc -l <lib/particulate/topic/laws.hpp)" ] || complain 'the filter must keep the lines'
for bad in 'X 1.3' 'M 33' 'M1.33' 'D 1.4.3, 1.5' ''; do
  printf '/// @equation{%s}\nvoid f();\n' "$bad" >lib/bad.hpp
  refuses 2 "given: {$bad}" equations lib/bad.hpp
done
printf '/// @equation{M 1.33}\n' >lib/bad.hpp
refuses 2 'stands above nothing' equations lib/bad.hpp
printf 'void f();\n' >lib/bad.hpp
refuses 2 'no @equation' equations lib/bad.hpp

# --- svgtheme.awk and draw.sh ----------------------------------------------------------------------------------------
printf 'load style\nset output "ch01_line.svg"\nplot data."/line.csv" using 1:2 with lines title "line"\n' >line.gp
mkdir -p data
printf 'x,y\n1,2\n2,3\n' >data/line.csv
refuses 1 'has no stamp' "$docs/draw.sh" line.gp "$work/figures" "data=$work/data"
echo '{}' >data/stamp.json && touch data/unfinished.txt
refuses 1 'has no stamp' "$docs/draw.sh" line.gp "$work/figures" "data=$work/data"
rm data/unfinished.txt
"$docs/draw.sh" line.gp "$work/figures" "data=$work/data"
holds figures/ch01_line.svg 'prefers-color-scheme:dark' '</svg>'
lacks figures/ch01_line.svg 'fill="#ffffff"'
printf 'load style\nset output "discs.svg"\nset xrange [0:4]\nset yrange [0:4]\nplot "-" using 1:2:3:4 with circles fs solid 1 border rgb "black" lc palette\n1,1,0.1,5\n2,1,0.1,7\n3,3,0.9,7\ne\n' >discs.gp
"$docs/draw.sh" discs.gp "$work/figures"
holds figures/discs.svg "fill='none' stroke='black'/>" '<polygon fill' '</svg>'
[ "$(grep -c '<circle cx' figures/discs.svg)" = 6 ] || complain 'svgtheme.awk must make circles of what is round'
printf 'load style\nset output "a.svg"\nplot data."/nosuch.csv" using 1:2\n' >bad.gp
refuses 1 'gnuplot complains' "$docs/draw.sh" bad.gp "$work/bad" "data=$work/data"
printf 'load style\n' >bad.gp
refuses 1 'drew no SVG file' "$docs/draw.sh" bad.gp "$work/bad"
printf '<svg></svg>\n' >bad.svg
refuses 2 'not an SVG that gnuplot finished' awk -v out="$work/bad" -f "$docs/svgtheme.awk" bad.svg

# --- guide: tables ---------------------------------------------------------------------------------------------------
mkdir -p run tables pages work
printf 'name,value [m]\r\n"a, ""b"" <c>\n@d",0.30000000000000004\r\nnone,nan\r\n' >run/short.csv
{ echo n && seq 201; } >run/long.csv
printf 'what,caught by\nsign,"ch01: period, race; ch02: x"\n' >run/caught.csv
echo 'alpha1 = 0.5' >run/parameters.toml
"$guide" tables run ch01 tables
holds tables/ch01_short.html 'a, &quot;b&quot; &lt;c&gt;' '&#64;d' '<td class="number">0.3</td>' '<th class="number">value [m]</th>'
holds tables/ch01_parameters.toml 'alpha1 = 0.5'
holds tables/ch01_caught.html '<a href="verify_ch01.html#verify_ch01_period">period</a>, <a href="verify_ch01.html#verify_ch01_race">race</a>; <a href="verify_ch02.html#verify_ch02_x">'
[ ! -e tables/ch01_long.html ] || complain 'a table of 201 rows is a curve and must not become a page'
refuses 2 'guide:' "$guide" tables nosuch ch01 tables
touch run/unfinished.txt
refuses 2 'a run that ended' "$guide" tables run ch01 tables
rm run/unfinished.txt

# --- guide: pages ----------------------------------------------------------------------------------------------------
head='chapter,case,claim,equation,reference,quantity,expected,computed,error,metric,tolerance,because,verdict,run,seconds'
cat >run/rows.csv <<H
$head
ch01,period,the period is \pi,D 1.36,closed form,T [s],3.141592653589793,3.1415926535897,1e-14,relative,1e-12,"sqrt, product",pass,quick,0.01
ch01,period,the period is \pi,D 1.36,closed form,E [J],1,nan,nan,relative,1e-12,product,fail,quick,0.01
ch01,race,orders,D 1.4.1,convergence,"pair, RK4: slope",4,4.02,0.02,order,0.2,theory,pass,quick,0.01
H
printf 'chapter,case,source\nch01,period,ch01_fundamentals/closed_orbits.cpp\nch01,race,ch01_fundamentals/race.cpp\n' >run/cases.csv
printf 'chapter,case,must,verdict,reason\nch01,a,refused,refused,coincident\nch01,b,solved,wrong,off\n' >run/stability.csv
cat >run/work_precision.csv <<'H'
chapter,problem,method,setting,tuned,error_end,error_max,floor,reference,seconds_min,seconds_median,seconds_overhead,evaluations,iterations,status
ch01,pair,RK4,0.1,no,1e-3,1e-3,1e-15,closed form,1e-5,2e-5,1e-6,100,0,solved
ch01,pair,RK4,0.05,no,1e-5,1e-5,1e-15,closed form,5e-5,6e-5,5e-6,316,0,solved
ch01,pair,RK4,0.01,no,1e-7,1e-7,1e-15,closed form,1e-4,2e-4,1e-5,1000,0,solved
ch01,pair,CVODE Adams,1e-3,no,,,1e-15,closed form,,,,77,0,failed: too much work
ch01,pair,CVODE Adams,1e-14,no,5e-15,5e-15,1e-15,closed form,1e-3,1e-3,1e-4,5000,9,at floor
H
refuses 2 'a run that ended' "$guide" pages pages work ch01_fundamentals=run
echo '{"revision": "abc", "seed": 7}' >run/stamp.json
"$guide" pages pages work ch01_fundamentals=run
holds pages/verify_ch01.md '# Chapter 1: Fundamentals, verified {#verify_ch01}' '<td class="number">1</td><td>1 closed form, 1 convergence</td>' \
  '<tr class="bad"><td>E [J]</td>' '### Closed orbits' '<details class="claim bad" open><summary>The period is &#92;pi.' \
  '@anchor verify_ch01_period' '<details class="claim"><summary>Orders.' '<tr class="bad"><td>b</td>' \
  '<td>CVODE Adams</td><td class="number">0.001</td><td>failed: too much work</td>' '<td>revision</td><td>abc</td>' \
  'are not drawn: 1 here' '@image html ch01_work_pair_seconds.svg'
holds pages/verification_guide.md '<tr class="bad"><td><a href="verify_ch01.html">' '@subpage verify_ch01'
holds work/ch01_work.gp "'RK4, order 4.02'" 'slope[1] = 4' 'slopes = 1' 'curves = 1' 'failures = 1'
lacks work/ch01_work_pair.csv '5e-15'
holds work/ch01_work_pair.csv '0.001,1e-05,2e-05,100'
"$docs/draw.sh" work/ch01_work.gp "$work/figures" "points=$work/work"
holds figures/ch01_work_pair_evaluations.svg 'RK4, order 4.02' 'failed'
holds figures/ch01_work_pair_seconds.svg '</svg>'

spoil() { cp run/rows.csv rows.kept && "$@" && "$guide" pages pages work ch01_fundamentals=run; }
refuses 2 'no column named verdict' spoil sed -i 's/verdict,run/opinion,run/' run/rows.csv
mv rows.kept run/rows.csv
refuses 2 'nothing was verified' spoil sed -i 2,99d run/rows.csv
mv rows.kept run/rows.csv
refuses 2 'rows.csv' spoil sed -i 's/,quick,/,/' run/rows.csv
mv rows.kept run/rows.csv
refuses 2 'a chapter is given as chNN_slug=folder, got nonsense' "$guide" pages pages work nonsense
refuses 2 'usage' "$guide" nonsense

[ "$wrong" = 0 ] && echo 'every generator does what it should, and refuses what it should'
