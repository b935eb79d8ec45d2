// The last step of Newton's method for the foot point of a four-node face, and the gap, in any type of numbers: the
// input of tools for derivatives.  x: A, B, C, D, xS; u, v: xi and eta from a search in double.
#ifndef FOOTPOINT_LAST_STEP_H
#define FOOTPOINT_LAST_STEP_H

#include <cmath>

template <typename T> T last_step_dot(const T a[3], const T b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename T> struct last_step_frame {
    T r_xi[3], r_eta[3], twist[3], offset[3];
    last_step_frame(const T *x, const T &u, const T &v)
    {
        for (int k = 0; k < 3; k++) {
            const T c1 = 0.25 * (x[3 + k] - x[k] + x[6 + k] - x[9 + k]),
                    c2 = 0.25 * (x[9 + k] - x[k] + x[6 + k] - x[3 + k]);
            twist[k] = 0.25 * (x[k] - x[3 + k] + x[6 + k] - x[9 + k]);
            r_xi[k] = c1 + v * twist[k];
            r_eta[k] = c2 + u * twist[k];
            offset[k] = x[12 + k] - 0.25 * (x[k] + x[3 + k] + x[6 + k] + x[9 + k]) - u * c1 - v * r_eta[k];
        }
    }
};

// Computes xi, eta and gap.
template <typename T> void last_step(const T *x, T u, T v, T out[3])
{
    using std::sqrt;
    {
        const last_step_frame<T> f(x, u, v);
        const T a = last_step_dot(f.r_xi, f.r_xi), b = last_step_dot(f.r_eta, f.r_eta),
                c = last_step_dot(f.r_xi, f.r_eta) - last_step_dot(f.offset, f.twist),
                p = last_step_dot(f.r_xi, f.offset), q = last_step_dot(f.r_eta, f.offset),
                scale = 1.0 / (a * b - c * c);
        u = u + (b * p - c * q) * scale;
        v = v + (a * q - c * p) * scale;
    }
    const last_step_frame<T> f(x, u, v);
    T n[3];
    for (int k = 0; k < 3; k++)
        n[k] = f.r_xi[(k + 1) % 3] * f.r_eta[(k + 2) % 3] - f.r_xi[(k + 2) % 3] * f.r_eta[(k + 1) % 3];
    out[0] = u;
    out[1] = v;
    out[2] = last_step_dot(n, f.offset) / sqrt(last_step_dot(n, n));
}

#endif
