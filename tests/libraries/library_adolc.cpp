// ADOL-C: the Jacobian of a last Newton step, taped once for all faces, because it has no branch.
#include "library.h"

#include "last_step.h"

#include <adolc/adolc.h>

namespace
{
enum { TAPE = 1, INPUTS = 17 };

// Inputs: 15 coordinates, and the search's xi and eta.
void record(const double *x)
{
    adouble y[INPUTS], out[3];
    double value;
    trace_on(TAPE);
    for (int i = 0; i < INPUTS; i++)
        y[i] <<= x[i];
    last_step<adouble>(y, y[15], y[16], out);
    for (auto &o : out)
        o >>= value;
    trace_off();
}

int differentiate(const double *x, const double loc[2], double d[3][15])
{
    static bool recorded;
    double all[INPUTS], row[3][INPUTS], *rows[3] = {row[0], row[1], row[2]};
    for (int i = 0; i < INPUTS; i++)
        all[i] = i < 15 ? x[i] : loc[i - 15];
    if (!recorded)
        record(all);
    recorded = true;
    if (jacobian(TAPE, 3, INPUTS, all, rows) < 0)
        return 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 15; j++)
            d[i][j] = row[i][j];
    return 1;
}

const library_derivative derivatives[] = {{"jacobian", "of a tape of the last Newton step", differentiate}};
const library self = {"ADOL-C", LIBRARY_VERSION, 0, nullptr, 1, derivatives};
} // namespace

const library *library_open()
{
    return &self;
}
