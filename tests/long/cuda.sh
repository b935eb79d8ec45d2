# Generated headers in device code: every function compiles where there is nvcc, and where there is a GPU each function of
# one face and one slave node answers there as on the host on ordinary segments: the same status and region, and all else to
# 1e-9 (1e-3 in single precision), relative to what is greater than one.  Both sides compute the same operations, but the
# device contracts to fused multiply-adds.
. tests/cli/expect.inc
command -v nvcc > /dev/null || { echo 'ok 1 - # skip no nvcc'; exit 0; }
arch= headers=
! nvidia-smi -L > /dev/null 2>&1 || arch=-arch=native headers=$(ls generated/*.h | grep -v _edge)
[ -n "$headers" ] || report 1 'skipped: answers on a GPU (none here)'

# program HEADER: every function called by what its declaration says, in a kernel and here
program() {
    cat <<CU
#include "$(basename "$1")"
#include <math.h>
#include <stdio.h>
#include <vector>
CU
    cat <<'CU'
enum { PAIRS = 20000, THREADS = 128 };

static double draw(void) /* in [-0.5, 0.5) */
{
    static unsigned long long seed = 1;
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(seed >> 40) / 16777216.0 - 0.5;
}

/* Nodes xA, xB, ..., unit normals nA, nB, ... there, the slave node xS: near the places of a face that is plane. */
static void place(const char *name, bool triangle, double p[3])
{
    static const double quad[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double tri[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    const double by[3] = {draw(), draw(), draw()};
    if (name[0] == 'n') {
        const double length = sqrt(0.04 * (by[0] * by[0] + by[1] * by[1]) + 1);
        p[0] = 0.2 * by[0] / length;
        p[1] = 0.2 * by[1] / length;
        p[2] = 1 / length;
    } else if (name[1] == 'S') {
        p[0] = triangle ? 0.3 + 0.4 * by[0] : 1.8 * by[0];
        p[1] = triangle ? 0.3 + 0.4 * by[1] : 1.8 * by[1];
        p[2] = 0.2 * by[2];
    } else {
        const double *const at = triangle ? tri[name[1] - 'A'] : quad[name[1] - 'A'];
        p[0] = at[0] + 0.1 * by[0];
        p[1] = at[1] + 0.1 * by[1];
        p[2] = 0.1 * by[2];
    }
}

template <typename T, void (*call)(const T *, T *)> __global__ void run(const T *in, size_t ins, T *out, size_t outs)
{
    const size_t p = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    if (p < PAIRS)
        call(in + ins * p, out + outs * p);
}

/* A pair's input: its points, a direction, a place (xi, eta); its output: status, region, then the numbers. */
template <typename T, void (*call)(const T *, T *)> static int same(const char *function, const char *points, size_t outs)
{
    size_t n = 0;
    while (points[2 * n] != '\0')
        n++;
    const size_t ins = 3 * n + 5;
    const bool triangle = n == 4 || n == 7; /* of three or six nodes, with the slave node */
    std::vector<T> in(ins * PAIRS), out(outs * PAIRS), here(outs);
    for (size_t p = 0; p < PAIRS; p++) {
        T *const x = in.data() + ins * p;
        for (size_t k = 0; k < n; k++) {
            double point[3];
            place(points + 2 * k, triangle, point);
            for (size_t i = 0; i < 3; i++)
                x[3 * k + i] = (T)point[i];
        }
        const double rest[5] = {0.2 * draw(), 0.2 * draw(), 1, triangle ? 0.3 : 0.8 * draw(), triangle ? 0.4 : 0.8 * draw()};
        for (size_t i = 0; i < 5; i++)
            x[3 * n + i] = (T)rest[i];
    }
    T *a, *b;
    if (cudaMalloc((void **)&a, in.size() * sizeof(T)) != cudaSuccess ||
        cudaMalloc((void **)&b, out.size() * sizeof(T)) != cudaSuccess ||
        cudaMemcpy(a, in.data(), in.size() * sizeof(T), cudaMemcpyHostToDevice) != cudaSuccess ||
        cudaMemcpy(b, out.data(), out.size() * sizeof(T), cudaMemcpyHostToDevice) != cudaSuccess)
        return printf("%s: no memory\n", function), 1;
    run<T, call><<<(PAIRS + THREADS - 1) / THREADS, THREADS>>>(a, ins, b, outs);
    if (cudaMemcpy(out.data(), b, out.size() * sizeof(T), cudaMemcpyDeviceToHost) != cudaSuccess)
        return printf("%s does not run: %s\n", function, cudaGetErrorString(cudaGetLastError())), 1;
    cudaFree(a);
    cudaFree(b);
    double off = 0;
    int answered = 0;
    for (size_t p = 0; p < PAIRS; p++) {
        for (size_t k = 0; k < outs; k++)
            here[k] = 0;
        call(in.data() + ins * p, here.data());
        const T *const there = out.data() + outs * p;
        answered += here[0] == 0;
        for (size_t k = 0; k < outs; k++) {
            const double d = fabs((double)(here[k] - there[k])) / fmax(1, fabs((double)here[k]));
            if (!(d <= (k < 2 ? 0 : sizeof(T) == 4 ? 1e-3 : 1e-9)))
                return printf("%s, pair %zu, answer %zu: %.17g here, %.17g there\n", function, p, k, (double)here[k],
                              (double)there[k]), 1;
            off = fmax(off, d);
        }
    }
    printf("%s: off by at most %.1e, %d of %d answered\n", function, off, answered, (int)PAIRS);
    return answered < PAIRS / 2;
}
CU
    tr '\n' ' ' < "$1" | sed 's/FOOTPOINT_FN int/\n&/g' |
        sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(\(const [a-z]* xA[^)]*\)).*/\1,\2/p' | tr -s ' ' |
        grep -v '^footpoint_detail_' | awk -F ', *' '
        {
            points = calls = ""; n = 0; outs = 2
            for (i = 2; i <= NF; i++)
                if ($i ~ /^const [a-z]* [xn][A-Z]\[3\]$/)
                    n++
            k = 0
            for (i = 2; i <= NF; i++) {
                type = $i; sub(/^const /, "", type); sub(/ .*/, "", type)
                if (i == 2) real = type
                name = $i; sub(/\[.*/, "", name); sub(/^.*[ *]/, "", name)
                size = $i ~ /\[/ ? $i : 1; gsub(/^.*\[|\]$/, "", size)
                if ($i ~ /^const [a-z]* [xn][A-Z]\[3\]$/) {
                    points = points name; what = "in + " 3 * k++
                } else if ($i ~ /^const/)
                    what = "in + " 3 * n + (name == "loc" ? 3 : 0)
                else if (type == "int")
                    what = "&" name
                else {
                    what = "out + " outs; outs += size
                }
                calls = calls (i > 2 ? ", " : "") what
            }
            print "static __host__ __device__ void call_" $1 "(const " real " *in, " real " *out)"
            print "{\n    int region = 0;\n    out[0] = (" real ")" $1 "(" calls ");\n    out[1] = (" real ")region;\n}\n"
            main = main "    bad += same<" real ", call_" $1 ">(\"" $1 "\", \"" points "\", " outs ");\n"
        }
        END {
            print "int main()\n{\n    int devices = 0, bad = 0;"
            print "    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)\n        return puts(\"no GPU\"), 77;"
            print main "    return bad != 0 || " NR " == 0;\n}"
        }'
}

# Compiled side by side: a header takes 3 to 22 seconds.
for header in $headers; do
    cp "$header" "$work/" && program "$header" > "$work/$(basename "$header" .h).cu"
done
[ -z "$headers" ] || (cd "$work" && ls ./*.cu | xargs -P "$(nproc)" -I{} sh -c 'nvcc -O2 '"$arch"' {} -o {}.run > {}.log 2>&1')
for header in $headers; do
    name=$(basename "$header" .h)
    run=$work/$name.cu.run
    [ -x "$run" ] || sed 's/^/# /' "$work/$name.cu.log" | head -20
    [ -x "$run" ]; report $((! $?)) "$name compiles for the device"
    [ -x "$run" ] || continue
    "$run" > "$work/log"
    status=$?
    [ $status != 77 ] || { report 1 "skipped: $name on a GPU (none here)"; continue; }
    sed 's/^/# /' "$work/log"
    report $((status == 0)) "$name answers there as here"
done

# All functions, called from one kernel; neither inlined nor optimised, which takes minutes a header and refuses nothing.
apart='-DFOOTPOINT_FN=static __host__ __device__ __noinline__'
for header in generated/*.h; do
    device_kernel "$PWD/$header" > "$work/$(basename "$header" .h).every.cu"
done
(cd "$work" && ls ./*.every.cu | xargs -P "$(nproc)" -I{} sh -c 'nvcc -ptx -Xcicc -O0 "'"$apart"'" {} -o {}.ptx > {}.log 2>&1')
for header in generated/*.h; do
    name=$(basename "$header" .h)
    [ -e "$work/$name.every.cu.ptx" ] || sed 's/^/# /' "$work/$name.every.cu.log" | head -20
    [ -e "$work/$name.every.cu.ptx" ]; report $((! $?)) "$name, every function compiles for the device"
done

# A batch out of a mesh's arrays, the example to copy: answers are the host's, to the bit where nothing is contracted.
nvcc -O3 $arch -fmad=false -I generated tests/example/pairs.cu -o "$work/pairs" > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
report $((!good)) 'pairs.cu compiles for the device'
if [ $good = 0 ]; then
    "$work/pairs" > "$work/log"
    status=$?
    sed 's/^/# /' "$work/log"
    [ $status != 77 ] || { report 1 'skipped: pairs.cu on a GPU (none here)'; exit 0; }
    [ $status = 0 ] && [ "$(grep -c "off the host's by 0.0e+00" "$work/log")" = 3 ]
    report $((! $?)) 'pairs.cu answers there as here, to the bit'
fi
