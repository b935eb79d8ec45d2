// dune-geometry: MultiLinearGeometry::local, Gauss-Newton iteration from the centre, without a limit on the number of steps.
#include "library.h"

#include <array>
#include <cmath>
#include <dune/common/fvector.hh>
#include <dune/geometry/multilineargeometry.hh>
#include <dune/geometry/type.hh>
#include <optional>

namespace
{
using Face = Dune::MultiLinearGeometry<double, 2, 3>;
using Point = Dune::FieldVector<double, 3>;
using Work = std::optional<Face>;

void *open_face(int)
{
    return new Work;
}

void set(void *work, const double *x)
{
    static const int order[4] = {0, 1, 3, 2};
    std::array<Point, 4> corner;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            corner[i][k] = x[3 * order[i] + k];
    static_cast<Work *>(work)->emplace(Dune::GeometryTypes::quadrilateral,
                                       std::vector<Point>(corner.begin(), corner.end()));
}

int find(void *work, const double xs[3], library_answer *a)
{
    const auto loc = (*static_cast<Work *>(work))->local(Point{xs[0], xs[1], xs[2]});
    for (int k = 0; k < 2; k++)
        a->loc[k] = 2 * loc[k] - 1;
    return std::fabs(loc[0]) < 1e300 ? LIBRARY_ANSWER : LIBRARY_NONE; // its largest number: not invertible
}

void close_face(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {{"local", 1u << LIBRARY_QUAD4, LIBRARY_FOOT,
                                    "MultiLinearGeometry::local; no limit of steps", open_face, set, find, close_face}};
const library self = {"dune-geometry", LIBRARY_VERSION, 1, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
