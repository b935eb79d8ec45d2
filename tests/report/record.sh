# record.sh BENCH ISA...: writes what this machine measures to tests/report/machines: for each instruction set the times of
# footpoint-bench on four-node faces and patches, and what tests/example/impact.c prints. The first line names processor,
# compiler and date.
bench=$1 folder=tests/report/machines
shift
model() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -1; }
processor="$(model 'model name'), family $(model 'cpu family') model $(model model)"
mkdir -p $folder && work=$(mktemp -d) || exit
trap 'rm -rf "$work"' EXIT
# keep FILE NAME: the file in its place, with its first line
keep() { { echo "# $about"; cat "$1"; } > "$folder/$2" && echo "$folder/$2"; }
for isa; do
    for scene in quad4 gregory bezier; do
        "$bench" --isa "$isa" --csv --quiet --scene $scene || continue 2
    done > "$work/times"
    compiler=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "compiler") k = i } NR == 2 { print $k }' "$work/times")
    about="$processor, $isa, $compiler, $(date -u +%F)"
    name=$(echo "$processor-$isa" | tr 'A-Z ,' 'a-z--' | tr -s -)
    keep "$work/times" "$name.csv"
    case $isa in x86-64*) march=-march=$isa ;; *) march= ;; esac
    ${CC:-gcc} -O3 $march -fno-math-errno -fno-trapping-math tests/example/impact.c -o "$work/impact" -lm &&
        "$work/impact" > "$work/told" && keep "$work/told" "$name-impact.txt"
done
