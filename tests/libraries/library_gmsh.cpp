// Gmsh: getLocalCoordinatesInElement of an element of its mesh.
#include "library.h"

#include <gmsh.h>
#include <mutex>
#include <vector>

namespace
{
struct Work {
    int kind;
    std::size_t element;
    std::vector<std::size_t> nodes;
};

void start()
{
    static std::once_flag once;
    std::call_once(once, [] {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::model::add("faces");
        gmsh::model::addDiscreteEntity(2, 1);
    });
}

void *open_element(int kind)
{
    static const int type[LIBRARY_KINDS] = {3, 9, 16, 10}, nodes[LIBRARY_KINDS] = {4, 6, 8, 9};
    static std::size_t last_node, last_element;
    start();
    auto *const w = new Work{kind, ++last_element, {}};
    std::vector<double> coordinates;
    for (int i = 0; i < nodes[kind]; i++) {
        w->nodes.push_back(++last_node);
        coordinates.insert(coordinates.end(), {double(i), double(i * i), 0});
    }
    gmsh::model::mesh::addNodes(2, 1, w->nodes, coordinates);
    gmsh::model::mesh::addElementsByType(1, type[kind], {w->element}, w->nodes);
    return w;
}

void set(void *work, const double *x)
{
    auto *const w = static_cast<Work *>(work);
    for (std::size_t i = 0; i < w->nodes.size(); i++)
        gmsh::model::mesh::setNode(w->nodes[i], {x[3 * i], x[3 * i + 1], x[3 * i + 2]}, {});
}

int find(void *work, const double xs[3], library_answer *a)
{
    double w;
    try {
        gmsh::model::mesh::getLocalCoordinatesInElement(static_cast<Work *>(work)->element, xs[0], xs[1], xs[2],
                                                        a->loc[0], a->loc[1], w);
    } catch (...) {
        return LIBRARY_NONE;
    }
    return LIBRARY_ANSWER;
}

void close_element(void *work)
{
    delete static_cast<Work *>(work);
}

const library_search searches[] = {{"getLocalCoordinatesInElement", (1u << LIBRARY_KINDS) - 1, LIBRARY_FOOT,
                                    "of a surface element; gives no status", open_element, set, find, close_element}};
const library self = {"Gmsh", LIBRARY_VERSION, 1, searches, 0, nullptr};
} // namespace

const library *library_open()
{
    return &self;
}
