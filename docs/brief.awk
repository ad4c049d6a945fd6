#!/usr/bin/awk -f
# The brief of an assignment as a page of the site, line for line: chapters/chNN_<slug>/assignment/README.md becomes
# assignment_chNN, and what it links to on a code host, the chapter's source, becomes the chapter's page.
BEGIN { slug = ARGV[1]; sub(/\/assignment\/.*/, "", slug); sub(/.*\//, "", slug) }
FNR == 1 { $0 = $0 " {#assignment_" substr(slug, 1, index(slug, "_") - 1) "}" }
{ gsub("\\[[^]]*\\]\\(\\.\\./" slug "\\.cpp\\)", "@ref " slug); print }
