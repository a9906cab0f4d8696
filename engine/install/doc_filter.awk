#!/usr/bin/awk -f
# Headers as Doxygen should see them: the comment that opens a file describes the file, indented lines are formulas, and
# "eq." and "et al." end no sentence.
function is_comment(line) { return line ~ /^ *\/\/\/( |$)/ }
function is_formula(line) { return line ~ /^ *\/\/\/   +[^ ]/ }
function show(line) {
    if (in_formula && !is_formula(line)) { print "/// ~~~"; in_formula = 0 }
    if (!in_formula && is_formula(line)) { print "/// ~~~{.unparsed}"; in_formula = 1 }
    if (!in_formula && is_comment(line)) { gsub(/eq\. /, "eq.\\\\ ", line); gsub(/et al\. /, "et al.\\\\ ", line) }
    if (in_formula) gsub(/ {10,}/, "          ", line)
    print line
}
NR == 1 && /^\/\/ / { at_top = 1; print "/// @file" }
at_top && !/^\/\// { at_top = 0 }
at_top { sub(/^\/\//, "///") }
{ show($0) }
