#!/bin/sh
# verdict.sh VERDICT HEADER FOLDER: prints a run's verdict with the error bound of the header's FOOTPOINT_OK and times.  Each
# function and its shipped counterpart are compiled in FOLDER and timed over arrays of 1,000 pairs, the minimum of 20 runs.
# Without a compiler (CC) it prints estimated costs.
verdict=$1 header=$2 folder=$3
shipped=$PWD/generated/$(sed -n 's/^.*; \(footpoint_[a-z0-9]*\)_[a-z0-9]* has .*$/\1/p' "$verdict" | head -n 1).h
case $header in /*) ;; *) header=$PWD/$header ;; esac
grep -q "^use " "$verdict" || exec cat "$verdict"
mkdir -p "$folder" || exit 3
{
    printf '#include "%s"\n' "$header"
    [ "$shipped" = "$header" ] || printf '#include "%s"\n' "$shipped"
    cat << 'C'
#include <stdio.h>
#include <time.h>
enum { N = 1000, COLUMNS = 64 };
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
#define TIME(f)                                                                    \
    for (int run = 0; run < 20; run++) {                                           \
        const double start = seconds();                                            \
        for (int i = 0; i < 20; i++)                                               \
            f##_n(N, column, xi, eta);                                             \
        const double ns = 1e9 * (seconds() - start) / (20.0 * N);                  \
        least = run == 0 || ns < least ? ns : least;                               \
    }                                                                              \
    printf("%s %.1f\n", #f, least)
int main(void)
{
    static double x[COLUMNS][N], xi[N], eta[N];
    const double *column[COLUMNS];
    unsigned long long random = 1;
    double least = 0;
    for (int c = 0; c < COLUMNS; c++) {
        column[c] = x[c];
        for (int i = 0; i < N; i++)
            x[c][i] = 0.5 + (double)((random = 6364136223846793005u * random + 1442695040888963407u) >> 40) / 16777216.0;
    }
C
    sed -n 's/^use \(footpoint_[a-z0-9_]*\): .*; \(footpoint_[a-z0-9_]*\) has .*$/    TIME(\1);\n    TIME(\2);/p' "$verdict"
    echo '    return 0;'
    echo '}'
} > "$folder/times.c"
"${CC:-cc}" -O3 -march=native -fno-math-errno -fno-trapping-math -D_DEFAULT_SOURCE "$folder/times.c" -o "$folder/times" -lm \
    > "$folder/times.log" 2>&1 && "$folder/times" > "$folder/times.ns"
[ -e "$folder/times.ns" ] || : > "$folder/times.ns"
awk -v header="$header" '
    FILENAME == header { if ($1 == "#define" && sub(/_PROMISE$/, "", $2)) promise[tolower($2)] = $3; next }
    FILENAME ~ /times.ns$/ { ns[$1] = $2; next }
    !/^use / { print; next }
    {
        own = $2
        sub(/:$/, "", own)
        old = $8
        printf "use %s: error %s%s%s; %s has %s%s\n", own, $4, own in promise ? ", OK within " promise[own] : "",
            own in ns ? ", " ns[own] " ns a pair" : " at cost " $7 + 0, old, $10, old in ns ? ", " ns[old] " ns" : " at " $12
    }' "$header" "$folder/times.ns" "$verdict"
rm -f "$folder/times.c" "$folder/times" "$folder/times.log" "$folder/times.ns"
