# record.sh BENCH ISA...: writes footpoint-bench's measurements of quad4 on this machine to tests/report/machines, a
# file for each instruction set. The first line names processor, compiler and date.
bench=$1 folder=tests/report/machines
shift
model() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -1; }
processor="$(model 'model name'), family $(model 'cpu family') model $(model model)"
mkdir -p $folder && new=$(mktemp $folder/new.XXXXXX) || exit
trap 'rm -f "$new"' EXIT
for isa; do
    "$bench" --isa "$isa" --csv --quiet --scene quad4 > "$new" || continue
    compiler=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "compiler") k = i } NR == 2 { print $k }' "$new")
    name=$(echo "$processor-$isa" | tr 'A-Z ,' 'a-z--' | tr -s -)
    { echo "# $processor, $isa, $compiler, $(date -u +%F)"; cat "$new"; } > "$folder/$name.csv" && echo "$folder/$name.csv"
done
