#!/bin/sh
# Makes bricks.inp beside this script with awk; punch.inp, blocks.inp and blocks-nodes.inp with gmsh (Debian package
# gmsh) and awk.
set -eu
cd "$(dirname "$0")"
LC_ALL=C awk -f bricks.awk > bricks.inp
aside=$(mktemp -d)
trap 'rm -rf "$aside"' EXIT
gmsh -2 -v 1 -nt 1 -format inp -o "$aside/punch.inp" punch.geo
gmsh -3 -v 1 -nt 1 -format inp -o "$aside/blocks.inp" blocks.geo
LC_ALL=C awk -f gmsh.awk -f punch.awk "$aside/punch.inp" > punch.inp
LC_ALL=C awk -f gmsh.awk -f blocks.awk -v include=blocks-nodes.inp -v nodes_file=blocks-nodes.inp "$aside/blocks.inp" \
    > blocks.inp
