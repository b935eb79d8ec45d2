// Intrepid2: CellTools::mapToReferenceFrame, only for cells with the dimension of the space: here the hexahedron that a
// face sweeps along the normal of its centre. A point of the face has its local coordinates in this cell. A slave node
// off the face is projected along that normal, which is another question.
#include "library.h"

#include <Intrepid2_CellTools.hpp>
#include <Kokkos_Core.hpp>
#include <Shards_BasicTopologies.hpp>
#include <Trilinos_version.h>
#include <cmath>

namespace
{
using Device = Kokkos::DefaultHostExecutionSpace;
using View = Kokkos::DynRankView<double, Device>;

struct Work {
    shards::CellTopology cell;
    View nodes, point, reference;
};

void *open_cell(int)
{
    if (!Kokkos::is_initialized())
        Kokkos::initialize();
    auto *const w = new Work;
    w->cell = shards::CellTopology(shards::getCellTopologyData<shards::Hexahedron<8>>());
    w->nodes = View("nodes", 1, 8, 3);
    w->point = View("point", 1, 1, 3);
    w->reference = View("reference", 1, 1, 3);
    return w;
}

void set(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    double d[3], e[3], n[3], length = 0, edge = 0;
    for (int k = 0; k < 3; k++) {
        d[k] = x[6 + k] - x[k];
        e[k] = x[9 + k] - x[3 + k];
        edge = std::fmax(edge, std::fabs(d[k]));
    }
    for (int k = 0; k < 3; k++) {
        n[k] = d[(k + 1) % 3] * e[(k + 2) % 3] - d[(k + 2) % 3] * e[(k + 1) % 3];
        length += n[k] * n[k];
    }
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            const double half = 0.5 * edge * n[k] / std::sqrt(length);
            w->nodes(0, i, k) = x[3 * i + k] - half;
            w->nodes(0, 4 + i, k) = x[3 * i + k] + half;
        }
}

int find(void *work, const double xs[3], library_answer *a)
{
    auto *const w = static_cast<Work *>(work);
    for (int k = 0; k < 3; k++)
        w->point(0, 0, k) = xs[k];
    try {
        Intrepid2::CellTools<Device>::mapToReferenceFrame(w->reference, w->point, w->nodes, w->cell);
    } catch (...) {
        return LIBRARY_NONE;
    }
    a->loc[0] = w->reference(0, 0, 0);
    a->loc[1] = w->reference(0, 0, 1);
    return LIBRARY_ANSWER;
}

void close_cell(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {{"mapToReferenceFrame", 1u << LIBRARY_QUAD4, LIBRARY_POINT,
                                    "of the hexahedron on the face; made for many points at once", open_cell, set, find,
                                    close_cell}};
const library self = {"Intrepid2", TRILINOS_VERSION_STRING, 1, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
