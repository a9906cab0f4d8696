#!/bin/sed -Ef
# [words](file) becomes words; pictures and web addresses stay. Joins nothing: a link stands on one line.
s/(^|[^!])\[([^]]+)\]\(([^h)#][^)]*|h[^t)][^)]*)\)/\1\2/g
