// VTK: EvaluatePosition of the cells, which returns local coordinates inside and the closest point outside. VTK treats
// a vtkQuad as plane (the plane of its first three points), and quadratic cells as four vtkQuad or triangles, but
// returns local coordinates of the cell.
#include "library.h"

#include <vtkBiQuadraticQuad.h>
#include <vtkPoints.h>
#include <vtkQuad.h>
#include <vtkQuadraticQuad.h>
#include <vtkQuadraticTriangle.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

namespace
{
struct Work {
    vtkSmartPointer<vtkCell> cell;
    int nodes;
};

void *open_cell(int kind)
{
    auto *const w = new Work;
    if (kind == LIBRARY_QUAD4)
        w->cell = vtkSmartPointer<vtkQuad>::New();
    else if (kind == LIBRARY_TRI6)
        w->cell = vtkSmartPointer<vtkQuadraticTriangle>::New();
    else if (kind == LIBRARY_QUAD8)
        w->cell = vtkSmartPointer<vtkQuadraticQuad>::New();
    else
        w->cell = vtkSmartPointer<vtkBiQuadraticQuad>::New();
    w->nodes = static_cast<int>(w->cell->GetNumberOfPoints());
    for (int i = 0; i < w->nodes; i++)
        w->cell->GetPointIds()->SetId(i, i);
    return w;
}

void set(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    for (int i = 0; i < w->nodes; i++)
        w->cell->GetPoints()->SetPoint(i, x + 3 * i);
}

int find(void *work, const double xs[3], library_answer *a)
{
    double pcoords[3], square, weights[LIBRARY_NODES];
    int part = 0;
    auto *const w = static_cast<Work *>(work);
    const int inside = w->cell->EvaluatePosition(xs, a->point, part, pcoords, square, weights);
    a->is_point = inside == 0;
    for (int k = 0; k < 2; k++)
        a->loc[k] = w->nodes == 6 ? pcoords[k] : 2 * pcoords[k] - 1;
    return inside < 0 ? LIBRARY_NONE : LIBRARY_ANSWER;
}

void close_cell(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {
    {"vtkQuad", 1u << LIBRARY_QUAD4, LIBRARY_CLOSEST, "EvaluatePosition; takes the face for plane", open_cell, set,
     find, close_cell},
    {"vtkQuadraticTriangle", 1u << LIBRARY_TRI6, LIBRARY_CLOSEST,
     "EvaluatePosition; four triangles; beside the cell, on its continuation", open_cell, set, find, close_cell},
    {"vtkQuadraticQuad", 1u << LIBRARY_QUAD8, LIBRARY_CLOSEST,
     "EvaluatePosition; four vtkQuad; beside the cell, on its continuation", open_cell, set, find, close_cell},
    {"vtkBiQuadraticQuad", 1u << LIBRARY_QUAD9, LIBRARY_CLOSEST,
     "EvaluatePosition; four vtkQuad; beside the cell, on its continuation", open_cell, set, find, close_cell}};
const library self = {"VTK", VTK_VERSION, 4, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
