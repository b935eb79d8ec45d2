// CGAL: the AABB tree's closest point of a four-node face that is split into triangles, either four about the centre or
// 2 x 32 x 32.
#include "library.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#include <memory>
#include <vector>

namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Iterator = std::vector<Triangle>::const_iterator;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;

struct Work {
    std::vector<Triangle> triangles;
    std::unique_ptr<Tree> tree;
};

Point at(const double *x, double xi, double eta)
{
    const double n[4] = {(1 - xi) * (1 - eta) / 4, (1 + xi) * (1 - eta) / 4, (1 + xi) * (1 + eta) / 4,
                         (1 - xi) * (1 + eta) / 4};
    double r[3];
    for (int k = 0; k < 3; k++)
        r[k] = n[0] * x[k] + n[1] * x[3 + k] + n[2] * x[6 + k] + n[3] * x[9 + k];
    return Point(r[0], r[1], r[2]);
}

void *open_tree(int)
{
    return new Work;
}

void build(Work *w)
{
    w->tree = std::make_unique<Tree>(w->triangles.cbegin(), w->triangles.cend());
    w->tree->build();
}

void set_four(void *work, const double *x)
{
    static const double corner[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    auto *const w = static_cast<Work *>(work);
    w->triangles.clear();
    for (int i = 0; i < 4; i++)
        w->triangles.emplace_back(at(x, 0, 0), at(x, corner[i][0], corner[i][1]),
                                  at(x, corner[i + 1][0], corner[i + 1][1]));
    build(w);
}

void set_many(void *work, const double *x)
{
    constexpr int n = 32;
    auto *const w = static_cast<Work *>(work);
    w->triangles.clear();
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double a = 2.0 * i / n - 1, b = 2.0 * j / n - 1, c = a + 2.0 / n, d = b + 2.0 / n;
            w->triangles.emplace_back(at(x, a, b), at(x, c, b), at(x, c, d));
            w->triangles.emplace_back(at(x, a, b), at(x, c, d), at(x, a, d));
        }
    build(w);
}

int find(void *work, const double xs[3], library_answer *a)
{
    const Point p = static_cast<Work *>(work)->tree->closest_point(Point(xs[0], xs[1], xs[2]));
    a->is_point = 1;
    for (int k = 0; k < 3; k++)
        a->point[k] = p[k];
    return LIBRARY_ANSWER;
}

void close_tree(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {{"AABB_tree-4", 1u << LIBRARY_QUAD4, LIBRARY_CLOSEST,
                                    "closest_point of four triangles about the centre", open_tree, set_four, find,
                                    close_tree},
                                   {"AABB_tree-2048", 1u << LIBRARY_QUAD4, LIBRARY_CLOSEST,
                                    "closest_point of 2048 triangles", open_tree, set_many, find, close_tree}};
const library self = {"CGAL", CGAL_VERSION_STR, 2, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
