// GetFEM: bgeot::geotrans_inv_convex::invert, of a surface element in space.
#include "library.h"

#include <cmath>
#include <getfem/bgeot_geotrans_inv.h>
#include <gmm/getfem_arch_config.h>

namespace
{
struct Work {
    int kind;
    bgeot::pgeometric_trans transformation;
    std::vector<int> order; // of its nodes, in ours
    std::vector<bgeot::base_node> nodes;
    bgeot::base_node point, reference;
    bgeot::geotrans_inv_convex inverse;
};

void *open_element(int kind)
{
    static const char *const names[LIBRARY_KINDS] = {"GT_QK(2,1)", "GT_PK(2,2)", "GT_Q2_INCOMPLETE(2)", "GT_QK(2,2)"};
    static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}},
                        square[9][2] = {{0, 0},   {1, 0},   {1, 1},   {0, 1},    {0.5, 0},
                                        {1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0.5}};
    auto *const w = new Work{kind,
                             bgeot::geometric_trans_descriptor(names[kind]),
                             {},
                             {},
                             bgeot::base_node(3),
                             bgeot::base_node(2),
                             bgeot::geotrans_inv_convex()};
    const auto *const at = kind == LIBRARY_TRI6 ? triangle : square;
    for (const auto &node : w->transformation->geometric_nodes())
        for (int i = 0; i < (kind == LIBRARY_TRI6 ? 6 : 9); i++)
            if (std::fabs(node[0] - at[i][0]) + std::fabs(node[1] - at[i][1]) < 1e-9)
                w->order.push_back(i);
    w->nodes.assign(w->order.size(), bgeot::base_node(3));
    return w;
}

void set(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    for (std::size_t i = 0; i < w->nodes.size(); i++)
        for (int k = 0; k < 3; k++)
            w->nodes[i][k] = x[3 * w->order[i] + k];
    w->inverse.init(w->nodes, w->transformation);
}

int find(void *work, const double xs[3], library_answer *a)
{
    auto *const w = static_cast<Work *>(work);
    bool converged = true;
    try {
        for (int k = 0; k < 3; k++)
            w->point[k] = xs[k];
        w->inverse.invert(w->point, w->reference, converged);
    } catch (...) {
        return LIBRARY_NONE;
    }
    for (int k = 0; k < 2; k++)
        a->loc[k] = w->kind == LIBRARY_TRI6 ? w->reference[k] : 2 * w->reference[k] - 1;
    return converged ? LIBRARY_ANSWER : LIBRARY_NONE;
}

void close_element(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {{"invert", (1u << LIBRARY_KINDS) - 1, LIBRARY_POINT,
                                    "geotrans_inv_convex::invert; a point beside the face does not converge",
                                    open_element, set, find, close_element}};
const library self = {"GetFEM", GETFEM_PACKAGE_VERSION, 1, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
