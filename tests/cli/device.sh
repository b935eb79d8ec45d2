# Headers in device code: a kernel that calls every function of a header compiles for an AMD GPU, as HIP, and for an NVIDIA
# GPU, as CUDA, by clang; tests/long/cuda.sh does so by nvcc.  Mathematics and the words for kernels are the test's own, so
# that no runtime need be installed.  HEADERS: the folder with headers, generated if it is not set.
. tests/cli/expect.inc
command -v clang++ > /dev/null || { echo 'ok 1 - # skip no clang++'; exit 0; }
mkdir "$work/include"
cat > "$work/include/math.h" <<'END'
#define FOR_BOTH __attribute__((host, device))
FOR_BOTH static inline double fabs(double x) { return __builtin_fabs(x); }
FOR_BOTH static inline float fabsf(float x) { return __builtin_fabsf(x); }
FOR_BOTH static inline double sqrt(double x) { return __builtin_sqrt(x); }
FOR_BOTH static inline float sqrtf(float x) { return __builtin_sqrtf(x); }
FOR_BOTH static inline double copysign(double x, double y) { return __builtin_copysign(x, y); }
FOR_BOTH static inline float copysignf(float x, float y) { return __builtin_copysignf(x, y); }
FOR_BOTH double frexp(double x, int *exponent);
FOR_BOTH float frexpf(float x, int *exponent);
FOR_BOTH double ldexp(double x, int exponent);
FOR_BOTH float ldexpf(float x, int exponent);
END
cat > "$work/words.h" <<'END'
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __forceinline__ inline __attribute__((always_inline))
END

for header in "${HEADERS:-$PWD/generated}"/*.h; do
    device_kernel "$header" > "$work/$(basename "$header" .h).cu"
done
later 'device: machine code'
code=-fsyntax-only # which reports host functions that a kernel calls
[ -z "$FOOTPOINT_LONG" ] || code='-S -o /dev/null'
for target in 'hip gfx90a -nogpuinc -nogpulib' 'cuda sm_70 -nocudainc -nocudalib -D__CUDACC__'; do
    # shellcheck disable=SC2086
    set -- $target
    language=$1 gpu=$2
    shift 2
    # shellcheck disable=SC2086
    (cd "$work" && ls ./*.cu | xargs -P "$(nproc)" -I{} clang++ -std=c++11 -O0 -w -x "$language" --cuda-device-only \
        "--cuda-gpu-arch=$gpu" "$@" -Iinclude -include words.h $code {}) > "$work/log" 2>&1
    good=$?
    [ $good = 0 ] || head -20 "$work/log" | sed 's/^/# /'
    report $((!good)) "$(ls "$work"/*.cu | wc -l) headers, every function, $language for $gpu"
done
