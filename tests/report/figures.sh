# Prints FILE with the table between its markers made anew, see figures.awk: figures.sh FILE.
table=$(awk -f tests/report/figures.awk generated/footpoint_quad4.h evolve/genomes/quad4.gen tests/report/machines/*.csv) || exit
awk -v table="$table" '/^<!-- figures -->$/ { print; print table; on = 1 } /^<!-- end of figures -->$/ { on = 0 } !on && !/^<!-- figures -->$/' "$1"
