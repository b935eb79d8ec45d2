# Arrows run one way: evolve -> genome text <- codegen -> generated <- runtime.  Every #include is read.
. tests/cli/expect.inc

# includes FOLDER: the files that the C files of a folder include, "path" and <path>
includes() { sed -n 's/^ *# *include *\([<"][^>"]*\)[>"].*/\1/p' "$1"/*.[ch] | sort -u; }
check() { [ -z "$2" ]; good=$?; [ $good = 0 ] || echo "$2" | sed 's/^/# /'; report $((! good)) "$1"; }

check 'runtime takes only generated headers and the C library' \
    "$(includes runtime | grep -vxE '<(math|stddef|stdint|limits|float|string)\.h|"[a-z0-9_-]+\.h|"\.\./generated/[a-z0-9_]+\.h')"
check 'generated takes only math.h and stddef.h' "$(includes generated | grep -vxE '<(math|stddef)\.h')"
check 'codegen takes nothing of ours but itself' "$(includes codegen | grep '^"\.\.')"
check 'evolve takes genome text, its base and segment geometry' \
    "$(includes evolve | grep '^"\.\.' | grep -vxE '"\.\./codegen/(genome|base|outfile|segment)\.h|"\.\./runtime/footpoint-[a-z0-9]+-(geometry|normals)\.h')"
check 'MPI stops at evolve'"'"'s main program and its migration' \
    "$(grep -l 'include <mpi.h>' evolve/*.[ch] codegen/*.[ch] runtime/*.[ch] | grep -vxE 'evolve/(evolve_main|migrate|evolve_mpi)\.[ch]')"
check 'file names are unique' \
    "$(git ls-files 2> /dev/null | grep -E '\.(c|h|cpp|sh|awk)$' | sed 's|.*/||' | sort | uniq -d)"
