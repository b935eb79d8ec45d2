# Generated headers in device code: they compile where there is nvcc, and where there is a GPU, too, they answer there
# as on the host: xi, eta and gap to 1e-9 on ordinary segments.  Both sides compute the same operations, but the device
# contracts to fused multiply-adds.
. tests/cli/expect.inc
command -v nvcc > /dev/null || { echo 'ok 1 - # skip no nvcc'; exit 0; }

# program HEADER: every search function of a header on 20,000 ordinary segments, on both sides
program() {
    functions=$(sed -n 's/^FOOTPOINT_FN int \(footpoint_[a-z0-9_]*\)(const double xA.*/\1/p' "$1" |
        grep -v -e '^footpoint_detail_' -e '_closest$' -e '_along$')
    cat <<'CU'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
CU
    echo "#include \"$(basename "$1")\""
    cat <<'CU'
struct answer {
    double loc[2], gap;
    int status;
};
enum { PAIRS = 20000, THREADS = 128 };

static double draw(unsigned long long *seed)
{
    *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*seed >> 40) / 16777216.0 - 0.5;
}

static void draw_pair(double *x, unsigned long long *seed)
{
    static const double corner[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}};
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++)
            x[3 * k + i] = corner[k][i] + draw(seed) * (k == 4 ? (i == 2 ? 0.2 : 1.8) : (i == 2 ? 0.1 : 0.3));
}

static int same(const struct answer *a, const struct answer *b)
{
    return a->status == b->status && fabs(a->loc[0] - b->loc[0]) < 1e-9 && fabs(a->loc[1] - b->loc[1]) < 1e-9 &&
           fabs(a->gap - b->gap) < 1e-9;
}
CU
    for f in $functions; do
        cat <<CU
__global__ void device_$f(const double *x, struct answer *a)
{
    const int p = (int)(blockIdx.x * blockDim.x + threadIdx.x);
    x += 15 * p;
    if (p < PAIRS)
        a[p].status = $f(x, x + 3, x + 6, x + 9, x + 12, a[p].loc, &a[p].gap);
}
CU
    done
    cat <<'CU'
int main(void)
{
    double *x;
    struct answer *a;
    unsigned long long seed = 1;
    if (cudaMallocManaged(&x, 15 * PAIRS * sizeof *x) != cudaSuccess ||
        cudaMallocManaged(&a, PAIRS * sizeof *a) != cudaSuccess)
        return puts("no GPU"), 77;
    for (int p = 0; p < PAIRS; p++)
        draw_pair(x + 15 * p, &seed);
CU
    for f in $functions; do
        cat <<CU
    device_$f<<<(PAIRS + THREADS - 1) / THREADS, THREADS>>>(x, a);
    if (cudaDeviceSynchronize() != cudaSuccess)
        return puts("$f does not run"), 1;
    for (int p = 0; p < PAIRS; p++) {
        struct answer h;
        const double *const q = x + 15 * p;
        h.status = $f(q, q + 3, q + 6, q + 9, q + 12, h.loc, &h.gap);
        if (!same(&h, &a[p]))
            return printf("$f, pair %d: %.17g %.17g on the host, %.17g %.17g\n", p, h.loc[0], h.loc[1], a[p].loc[0],
                          a[p].loc[1]), 1;
    }
CU
    done
    echo '    return 0;'
    echo '}'
}

for scene in quad4 plane_quad4 parallelogram_quad4 rectangle_quad4; do
    header=generated/footpoint_$scene.h
    cp "$header" "$work/" && program "$header" > "$work/use.cu"
    nvcc -O2 "$work/use.cu" -o "$work/use" > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
    report $((!good)) "$scene compiles for the device"
    [ $good = 0 ] || continue
    "$work/use" > "$work/log"
    status=$?
    [ $status != 77 ] || { report 1 "skipped: $scene on a GPU (none here)"; continue; }
    [ $status = 0 ] || sed 's/^/# /' "$work/log"
    report $((status == 0)) "$scene answers there as here"
done

# A batch out of a mesh's arrays, the example to copy: answers are the host's, to the bit where nothing is contracted.
nvcc -O3 -fmad=false -I generated tests/example/pairs.cu -o "$work/pairs" > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log" | head -20
report $((!good)) 'pairs.cu compiles for the device'
if [ $good = 0 ]; then
    "$work/pairs" > "$work/log"
    status=$?
    sed 's/^/# /' "$work/log"
    [ $status != 77 ] || { report 1 'skipped: pairs.cu on a GPU (none here)'; exit 0; }
    [ $status = 0 ] && grep -q "off the host's by 0.0e+00" "$work/log"
    report $((! $?)) 'pairs.cu answers there as here, to the bit'
fi
