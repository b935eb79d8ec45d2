/* A batch of pairs on a GPU, the part to copy. The kernel search_pairs reads nodes, segments and slave nodes from a
 * mesh's own arrays, one pair per thread, and writes xi, eta, gap and status. It needs only
 * generated/footpoint_quad4.h. Every thread takes the same path for ordinary pairs; the header repeats unusual
 * searches. The search is a parameter of the kernel: foot point, closest point, or intersection with a ray.
 *
 *     nvcc -O3 -arch=native -I generated tests/example/pairs.cu -o pairs && ./pairs
 *
 * A wavy surface of 1000 x 1000 segments with a slave node over each. Compares the answers with the host's, to the bit
 * under -fmad=false, and the time per pair with a kernel that reads and writes as much but computes nothing. */
#include "footpoint_quad4.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

struct pairs {
    size_t n;
    const double *xyz; /* nodes x 3 */
    const int *seg;    /* n x 4, counter-clockwise seen from where slave nodes come */
    const int *slave;  /* n */
};

struct answers {
    double *xi, *eta, *gap;
    int *status;
};

typedef int search(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                   double loc[2], double *gap);

template <search find>
__host__ __device__ inline void search_pair(const struct pairs p, size_t i, const struct answers a)
{
    const double *const xA = p.xyz + 3 * (size_t)p.seg[4 * i], *const xB = p.xyz + 3 * (size_t)p.seg[4 * i + 1];
    const double *const xC = p.xyz + 3 * (size_t)p.seg[4 * i + 2], *const xD = p.xyz + 3 * (size_t)p.seg[4 * i + 3];
    double loc[2] = {0, 0}, gap = 0;
    a.status[i] = find(xA, xB, xC, xD, p.xyz + 3 * (size_t)p.slave[i], loc, &gap);
    a.xi[i] = loc[0];
    a.eta[i] = loc[1];
    a.gap[i] = gap;
}

template <search find> __global__ void search_pairs(const struct pairs p, const struct answers a)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    if (i < p.n)
        search_pair<find>(p, i, a);
}

/* The same memory traffic, a lower bound of the time of any search. */
__global__ void only_gather(const struct pairs p, const struct answers a)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    if (i >= p.n)
        return;
    double sum[3] = {0, 0, 0};
    for (int k = 0; k < 5; k++) {
        const double *const x = p.xyz + 3 * (size_t)(k < 4 ? p.seg[4 * i + k] : p.slave[i]);
        for (int j = 0; j < 3; j++)
            sum[j] += x[j];
    }
    a.xi[i] = sum[0];
    a.eta[i] = sum[1];
    a.gap[i] = sum[2];
    a.status[i] = 0;
}

/* ---- the example ---- */

__host__ __device__ static int closest(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                       const double xS[3], double loc[2], double *dist)
{
    int region;
    return footpoint_quad4_accurate_closest(xA, xB, xC, xD, xS, loc, dist, &region);
}

__host__ __device__ static int along(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                     const double xS[3], double loc[2], double *dist)
{
    const double down[3] = {0.1, 0.2, -1};
    return footpoint_quad4_along(xA, xB, xC, xD, xS, down, loc, dist);
}

enum { SIDE = 1000, THREADS = 128, ROUNDS = 20 };

static void check(cudaError_t e, const char *what)
{
    if (e != cudaSuccess) {
        std::fprintf(stderr, "pairs: %s: %s\n", what, cudaGetErrorString(e));
        std::exit(3);
    }
}

template <typename T> static T *on_device(const std::vector<T> &v)
{
    T *p = nullptr;
    check(cudaMalloc((void **)&p, v.size() * sizeof(T)), "memory");
    check(cudaMemcpy(p, v.data(), v.size() * sizeof(T), cudaMemcpyHostToDevice), "copy");
    return p;
}

static double wave(double x, double y)
{
    return 0.3 * std::sin(0.07 * x) * std::cos(0.05 * y);
}

/* Returns the least seconds of a kernel over some rounds. */
template <typename Kernel> static double seconds(Kernel kernel, const struct pairs &p, const struct answers &a)
{
    double least = HUGE_VAL;
    cudaEvent_t begin, end;
    check(cudaEventCreate(&begin), "event");
    check(cudaEventCreate(&end), "event");
    for (int round = 0; round < ROUNDS; round++) {
        float ms = 0;
        check(cudaEventRecord(begin), "event");
        kernel<<<(unsigned)((p.n + THREADS - 1) / THREADS), THREADS>>>(p, a);
        check(cudaEventRecord(end), "event");
        check(cudaEventSynchronize(end), "kernel");
        check(cudaEventElapsedTime(&ms, begin, end), "event");
        least = std::fmin(least, 1e-3 * ms);
    }
    return least;
}

template <search find> static bool compare(const char *name, const struct pairs &here, const struct pairs &there)
{
    const size_t n = here.n;
    std::vector<double> xi(n), eta(n), gap(n), got(n);
    std::vector<int> status(n), told(n);
    const struct answers host = {xi.data(), eta.data(), gap.data(), status.data()};
    const struct answers device = {on_device(xi), on_device(eta), on_device(gap), on_device(status)};
    for (size_t i = 0; i < n; i++)
        search_pair<find>(here, i, host);
    const double gathered = seconds(only_gather, there, device), searched = seconds(search_pairs<find>, there, device);
    double off = 0;
    const double *const from[3] = {device.xi, device.eta, device.gap}, *const with[3] = {xi.data(), eta.data(),
                                                                                         gap.data()};
    for (int k = 0; k < 3; k++) {
        check(cudaMemcpy(got.data(), from[k], n * sizeof(double), cudaMemcpyDeviceToHost), "copy");
        for (size_t i = 0; i < n; i++)
            off = std::fmax(off, std::fabs(got[i] - with[k][i]));
    }
    check(cudaMemcpy(told.data(), device.status, n * sizeof(int), cudaMemcpyDeviceToHost), "copy");
    std::printf("%s, %zu pairs: %.0f ps a pair, %.2f of a kernel that only gathers; off the host's by %.1e\n", name, n,
                1e12 * searched / n, searched / gathered, off);
    return off < 1e-9 && told == status;
}

int main()
{
    int devices = 0;
    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)
        return std::puts("no GPU"), 77;
    const size_t n = (size_t)SIDE * SIDE, nodes = (size_t)(SIDE + 1) * (SIDE + 1);
    std::vector<double> xyz;
    std::vector<int> seg, slave;
    for (int j = 0; j <= SIDE; j++)
        for (int i = 0; i <= SIDE; i++)
            for (double x : {(double)i, (double)j, wave(i, j)})
                xyz.push_back(x);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            const int a = j * (SIDE + 1) + i;
            for (int node : {a, a + 1, a + SIDE + 2, a + SIDE + 1})
                seg.push_back(node);
            slave.push_back((int)(nodes + slave.size()));
            const double x = i + 0.1 + 0.8 * (i * 7919 % 1000) / 1000.0,
                         y = j + 0.1 + 0.8 * (j * 104729 % 1000) / 1000.0;
            for (double s : {x, y, wave(x, y) + 0.1 * std::sin(i + 2.0 * j)})
                xyz.push_back(s);
        }
    const struct pairs here = {n, xyz.data(), seg.data(), slave.data()};
    const struct pairs there = {n, on_device(xyz), on_device(seg), on_device(slave)};
    const bool same[] = {compare<footpoint_quad4_accurate>("foot point", here, there),
                         compare<closest>("closest point", here, there),
                         compare<along>("along a direction", here, there)};
    return same[0] && same[1] && same[2] ? 0 : 1;
}
