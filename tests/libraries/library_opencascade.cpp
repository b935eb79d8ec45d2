// Open CASCADE: four-, eight- and nine-node faces as Bezier surfaces. GeomAPI_ProjectPointOnSurf finds points inside at
// which xS - r is normal to the surface. BRepExtrema_DistShapeShape finds the closest point, including edges and
// corners.
#include "library.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BezierSurface.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <memory>

namespace
{
constexpr double tolerance = 1e-9; // mesh length

struct Work {
    int kind;
    Handle(Geom_BezierSurface) surface;
    GeomAPI_ProjectPointOnSurf projection;
    TopoDS_Face face;
};

void *open_surface(int kind)
{
    auto *const w = new Work;
    w->kind = kind;
    return w;
}

gp_Pnt node(const double *x, int i)
{
    return gp_Pnt(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
}

// Returns the middle control point of three.
gp_XYZ middle(const gp_XYZ &a, const gp_XYZ &m, const gp_XYZ &b)
{
    return m * 2 - (a + b) * 0.5;
}

TColgp_Array2OfPnt controls(int kind, const double *x)
{
    static const int corner[4][2] = {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, side[4][2] = {{2, 1}, {3, 2}, {2, 3}, {1, 2}};
    const int order = kind == LIBRARY_QUAD4 ? 2 : 3;
    TColgp_Array2OfPnt c(1, order, 1, order);
    gp_XYZ corners, middles, sides;
    for (int i = 0; i < 4; i++) {
        if (order == 2) {
            c.SetValue(corner[i][0] == 1 ? 1 : 2, corner[i][1] == 1 ? 1 : 2, node(x, i));
            continue;
        }
        const gp_XYZ a = node(x, i).XYZ(), b = node(x, (i + 1) % 4).XYZ(), m = node(x, 4 + i).XYZ();
        c.SetValue(corner[i][0], corner[i][1], gp_Pnt(a));
        c.SetValue(side[i][0], side[i][1], gp_Pnt(middle(a, m, b)));
        corners += a;
        middles += m;
        sides += middle(a, m, b);
    }
    if (order == 3) {
        const gp_XYZ centre = kind == LIBRARY_QUAD9 ? node(x, 8).XYZ() : middles * 0.5 - corners * 0.25;
        c.SetValue(2, 2, gp_Pnt(centre * 4 - corners * 0.25 - sides * 0.5));
    }
    return c;
}

void set(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    w->surface = new Geom_BezierSurface(controls(w->kind, x));
    w->projection.Init(w->surface, 0, 1, 0, 1, tolerance, Extrema_ExtAlgo_Grad);
}

void set_face(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    w->surface = new Geom_BezierSurface(controls(w->kind, x));
    w->face = BRepBuilderAPI_MakeFace(w->surface, tolerance).Face();
}

int project(void *work, const double xs[3], library_answer *a)
{
    auto *const w = static_cast<Work *>(work);
    try {
        w->projection.Perform(gp_Pnt(xs[0], xs[1], xs[2]));
        if (!w->projection.IsDone() || w->projection.NbPoints() == 0)
            return LIBRARY_NONE;
        w->projection.LowerDistanceParameters(a->loc[0], a->loc[1]);
    } catch (const Standard_Failure &) {
        return LIBRARY_NONE;
    }
    for (double &z : a->loc)
        z = 2 * z - 1;
    return LIBRARY_ANSWER;
}

int distance(void *work, const double xs[3], library_answer *a)
{
    auto *const w = static_cast<Work *>(work);
    try {
        const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(xs[0], xs[1], xs[2]));
        BRepExtrema_DistShapeShape d(vertex, w->face);
        if (!d.IsDone() || d.NbSolution() == 0)
            return LIBRARY_NONE;
        const gp_Pnt p = d.PointOnShape2(1);
        a->is_point = 1;
        for (int k = 0; k < 3; k++)
            a->point[k] = p.Coord(k + 1);
    } catch (const Standard_Failure &) {
        return LIBRARY_NONE;
    }
    return LIBRARY_ANSWER;
}

void close_surface(void *work)
{
    delete static_cast<Work *>(work);
}

constexpr unsigned quads = 1u << LIBRARY_QUAD4 | 1u << LIBRARY_QUAD8 | 1u << LIBRARY_QUAD9;
const library_search searches[] = {
    {"ProjectPointOnSurf", quads, LIBRARY_INSIDE, "GeomAPI_ProjectPointOnSurf on a Bezier surface", open_surface, set,
     project, close_surface},
    {"DistShapeShape", quads, LIBRARY_CLOSEST, "BRepExtrema_DistShapeShape of a vertex and a face", open_surface,
     set_face, distance, close_surface}};
const library self = {"Open CASCADE", OCC_VERSION_COMPLETE, 2, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
