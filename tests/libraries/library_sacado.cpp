// Sacado: forward derivatives of a last Newton step in SFad<double, 15>, all on the stack.
#include "library.h"

#include "last_step.h"

#include <Sacado_No_Kokkos.hpp>
#include <Trilinos_version.h>

namespace
{
int differentiate(const double *x, const double loc[2], double d[3][15])
{
    using Number = Sacado::Fad::SFad<double, 15>;
    Number y[15], out[3];
    for (int i = 0; i < 15; i++)
        y[i] = Number(15, i, x[i]);
    last_step<Number>(y, loc[0], loc[1], out);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 15; j++)
            d[i][j] = out[i].dx(j);
    return 1;
}

const library_derivative derivatives[] = {{"SFad", "SFad<double;15> through the last Newton step", differentiate}};
const library self = {"Sacado", TRILINOS_VERSION_STRING, 0, nullptr, 1, derivatives};
} // namespace

const library *library_open()
{
    return &self;
}
