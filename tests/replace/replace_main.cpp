// Tests the adapters in C++ of runtime/replace/: Tribol, MOOSE, NimbleSM, ArborX, with minimal stand-ins for those
// codes.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

static int failures;
static void check(const char *name, bool good)
{
    if (!good)
        std::printf("# %s\n", name);
    failures += !good;
}

static double face[4][3] = {{0, 0, 0}, {2, 0, 0.1}, {2.2, 1.5, 0}, {0, 1.2, 0.1}};
static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

// Computes r, r_xi, r_eta and the normal.
static void frame(const double loc[2], double r[4][3])
{
    double length = 0;
    for (int k = 0; k < 3; k++) {
        r[0][k] = r[1][k] = r[2][k] = 0;
        for (int i = 0; i < 4; i++) {
            const double a = 1 + corner[i][0] * loc[0], b = 1 + corner[i][1] * loc[1];
            r[0][k] += 0.25 * a * b * face[i][k];
            r[1][k] += 0.25 * corner[i][0] * b * face[i][k];
            r[2][k] += 0.25 * a * corner[i][1] * face[i][k];
        }
    }
    for (int k = 0; k < 3; k++) {
        r[3][k] = r[1][(k + 1) % 3] * r[2][(k + 2) % 3] - r[1][(k + 2) % 3] * r[2][(k + 1) % 3];
        length += r[3][k] * r[3][k];
    }
    for (int k = 0; k < 3; k++)
        r[3][k] /= std::sqrt(length);
}

static void slave_at(double xi, double eta, double gap, double xs[3])
{
    const double loc[2] = {xi, eta};
    double r[4][3];
    frame(loc, r);
    for (int k = 0; k < 3; k++)
        xs[k] = r[0][k] + gap * r[3][k];
}

static bool near(double a, double b, double tolerance = 1e-9)
{
    return std::fabs(a - b) <= tolerance;
}

// ---- Tribol ----

namespace tribol
{
using RealT = double;
}
static int refused;
#define SLIC_ERROR_IF(what, text)                                                                                      \
    if (what) {                                                                                                        \
        refused++;                                                                                                     \
        return;                                                                                                        \
    }
#include "../../runtime/replace/tribol.hpp"

static void tribol_test()
{
    double x[4], y[4], z[4], xs[3], xi[2] = {7, 7}, phi[4], d[3][5][3];
    for (int i = 0; i < 4; i++) { // Tribol's first node is at (1,1)
        x[i] = face[(i + 2) % 4][0];
        y[i] = face[(i + 2) % 4][1];
        z[i] = face[(i + 2) % 4][2];
    }
    slave_at(0.3, -0.6, 0.05, xs);
    tribol::InvIso(xs, x, y, z, 4, xi);
    check("Tribol: quadrilateral", near(xi[0], 0.3) && near(xi[1], -0.6));
    check("Tribol: derivatives exist", tribol::InvIsoDerivatives(xs, x, y, z, xi, phi, d));
    check("Tribol: first shape function", near(phi[0], 0.25 * 1.3 * 0.4));
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            double *const one = i == 4 ? &xs[k] : k == 0 ? &x[i] : k == 1 ? &y[i] : &z[i], before = *one, a[2], b[2];
            *one = before + 1e-5;
            tribol::InvIso(xs, x, y, z, 4, a);
            *one = before - 1e-5;
            tribol::InvIso(xs, x, y, z, 4, b);
            *one = before;
            check("Tribol: derivatives",
                  near(d[0][i][k], (a[0] - b[0]) / 2e-5, 1e-7) && near(d[1][i][k], (a[1] - b[1]) / 2e-5, 1e-7));
        }
    slave_at(1, 0.5, 0, xs);
    tribol::InvIso(xs, x, y, z, 4, xi);
    check("Tribol: an edge", xi[0] <= 1 && near(xi[0], 1) && near(xi[1], 0.5));
    const double tx[3] = {0, 2, 0}, ty[3] = {0, 0, 1}, tz[3] = {0, 0, 0}, ts[3] = {0.5, 0.25, 0.1};
    tribol::InvIso(ts, tx, ty, tz, 3, xi);
    check("Tribol: triangle", near(xi[0], 0.25) && near(xi[1], 0.25));
    xs[0] = NAN;
    tribol::InvIso(xs, x, y, z, 4, xi);
    check("Tribol: refused", refused == 1);
}

// ---- MOOSE ----

#include "../../runtime/replace/moose.hpp"

struct Vector {
    double x[3];
    Vector(double a = 0, double b = 0, double c = 0) : x{a, b, c}
    {
    }
    double operator()(unsigned k) const
    {
        return x[k];
    }
    Vector operator-(const Vector &o) const
    {
        return Vector(x[0] - o.x[0], x[1] - o.x[1], x[2] - o.x[2]);
    }
    double operator*(const Vector &o) const
    {
        return x[0] * o.x[0] + x[1] * o.x[1] + x[2] * o.x[2];
    }
    Vector &operator/=(double s)
    {
        for (double &c : x)
            c /= s;
        return *this;
    }
    double norm() const
    {
        return std::sqrt(*this * *this);
    }
    Vector cross(const Vector &o) const
    {
        return Vector(x[1] * o.x[2] - x[2] * o.x[1], x[2] * o.x[0] - x[0] * o.x[2], x[0] * o.x[1] - x[1] * o.x[0]);
    }
};
struct Node {
    int number;
};
struct Side {
    Node node[4] = {{0}, {1}, {2}, {3}};
    Vector point(unsigned i) const
    {
        return Vector(face[i][0], face[i][1], face[i][2]);
    }
    const Node *node_ptr(unsigned i) const
    {
        return &node[i];
    }
};
struct Element {
    std::vector<Vector> xyz, xi, eta, xieta;
    std::vector<std::vector<double>> phi;
    std::vector<std::vector<Vector>> dphi;
    void reinit(const Side *, const std::vector<Vector> *points)
    {
        const double loc[2] = {(*points)[0](0), (*points)[0](1)};
        double r[4][3];
        frame(loc, r);
        xyz = {Vector(r[0][0], r[0][1], r[0][2])};
        xi = {Vector(r[1][0], r[1][1], r[1][2])};
        eta = {Vector(r[2][0], r[2][1], r[2][2])};
    }
    const std::vector<Vector> &get_xyz() const
    {
        return xyz;
    }
    const std::vector<Vector> &get_dxyzdxi() const
    {
        return xi;
    }
    const std::vector<Vector> &get_dxyzdeta() const
    {
        return eta;
    }
    const std::vector<Vector> &get_d2xyzdxideta() const
    {
        return xieta;
    }
    const std::vector<std::vector<double>> &get_phi() const
    {
        return phi;
    }
    const std::vector<std::vector<Vector>> &get_dphi() const
    {
        return dphi;
    }
};
struct Information {
    const Side *_side;
    Vector _closest_point_ref, _closest_point, _normal;
    double _distance, _tangential_distance;
    std::vector<Vector> _dxyzdxi, _dxyzdeta, _d2xyzdxideta;
    std::vector<std::vector<double>> _side_phi;
    std::vector<std::vector<Vector>> _side_grad_phi;
    std::vector<const Node *> _off_edge_nodes;
};

static void moose_test()
{
    const Side side;
    Element element;
    Information info;
    int type = 0;
    double xs[3];
    bool on_side = false, found = false;
    info._side = &side;
    slave_at(0.3, -0.6, -0.05, xs);
    footpoint_moose::findContactPoint(info, &element, &element, type, Vector(xs[0], xs[1], xs[2]), true, 0., on_side,
                                      found);
    check("MOOSE: inside",
          found && on_side && near(info._closest_point_ref(0), 0.3) && near(info._closest_point_ref(1), -0.6));
    check("MOOSE: penetration",
          near(info._distance, 0.05) && info._tangential_distance == 0 && info._off_edge_nodes.empty());
    slave_at(1.1, 0.2, -0.05, xs);
    footpoint_moose::findContactPoint(info, &element, &element, type, Vector(xs[0], xs[1], xs[2]), true, 0., on_side,
                                      found);
    check("MOOSE: beside an edge", found && !on_side && info._off_edge_nodes.size() == 2 &&
                                       info._off_edge_nodes[0]->number == 1 && info._off_edge_nodes[1]->number == 2 &&
                                       near(info._closest_point_ref(0), 1));
    const double beside = info._tangential_distance;
    check("MOOSE: how far beside", beside > 0.08 && beside < 0.12);
    footpoint_moose::findContactPoint(info, &element, &element, type, Vector(xs[0], xs[1], xs[2]), true, 0.2, on_side,
                                      found);
    check("MOOSE: tolerance", on_side);
    slave_at(1.4, 1.3, 0.05, xs);
    footpoint_moose::findContactPoint(info, &element, &element, type, Vector(xs[0], xs[1], xs[2]), false, 0., on_side,
                                      found);
    check("MOOSE: beside a corner",
          info._off_edge_nodes.size() == 1 && info._off_edge_nodes[0]->number == 2 && info._distance < 0);
    footpoint_moose::findContactPoint(info, &element, &element, type, Vector(NAN, 0, 0), false, 0., on_side, found);
    check("MOOSE: refused", !found);
    double corner_d[3];
    std::memcpy(corner_d, face[3], sizeof corner_d);
    std::memcpy(face[3], face[2], sizeof corner_d); // a triangle
    for (int behind = 0; behind < 2; behind++) {
        slave_at(0, 0, behind ? -0.05 : 0.05, xs);
        double middle[3];
        slave_at(0, 0, 0, middle);
        for (int k = 0; k < 3; k++) // straight over the collapsed corner
            xs[k] += face[2][k] - middle[k];
        footpoint_moose::findContactPoint(info, &element, &element, type, Vector(xs[0], xs[1], xs[2]), false, 0.,
                                          on_side, found);
        check("MOOSE: collapsed corner", found && near(std::fabs(info._distance), 0.05) &&
                                             (info._distance > 0) == (behind == 1) && near(info._normal.norm(), 1));
    }
    std::memcpy(face[3], corner_d, sizeof corner_d);
}

// ---- NimbleSM, ArborX ----

#include "../../runtime/replace/nimblesm.hpp"

struct Entity {
    double coord_1_x_, coord_1_y_, coord_1_z_, coord_2_x_, coord_2_y_, coord_2_z_, coord_3_x_, coord_3_y_, coord_3_z_,
        coord_4_x_, coord_4_y_, coord_4_z_;
};

static void nimble_test()
{
    const Entity f = {face[0][0], face[0][1], face[0][2], face[1][0], face[1][1], face[1][2],
                      face[2][0], face[2][1], face[2][2], face[3][0], face[3][1], face[3][2]};
    const double loc[2] = {0.3, -0.6};
    double xs[3], r[4][3], gap, normal[3], weight[4];
    bool in;
    frame(loc, r);
    slave_at(0.3, -0.6, -0.05, xs);
    Entity node = {xs[0], xs[1], xs[2], 0, 0, 0, 0, 0, 0, 0, 0, 0};
    nimble::Projection(node, f, in, gap, normal, weight);
    check("NimbleSM: inside",
          in && near(gap, -0.05) && near(weight[0], 0.25 * 0.7 * 1.6) && near(weight[2], 0.25 * 1.3 * 0.4));
    check("NimbleSM: normal", near(normal[0], r[3][0]) && near(normal[1], r[3][1]) && near(normal[2], r[3][2]));
    slave_at(1.2, 0, -0.05, xs);
    node = Entity{xs[0], xs[1], xs[2], 0, 0, 0, 0, 0, 0, 0, 0, 0};
    nimble::Projection(node, f, in, gap, normal, weight);
    check("NimbleSM: beside", !in);
    node.coord_1_x_ = NAN;
    nimble::Projection(node, f, in, gap, normal, weight);
    check("NimbleSM: refused", !in);
}

struct Query {
    int data;
};
static int getData(const Query &query)
{
    return query.data;
}
#include "../../runtime/replace/arborx.hpp"

static void arborx_test()
{
    double nodes[7][3], distance[1] = {10}, loc[1][2] = {{7, 7}};
    const int faces[2][4] = {{1, 4, 5, 2}, {0, 1, 2, 3}}, slaves[1] = {6};
    int which[1] = {-1};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            nodes[i][k] = face[i][k];
    for (int k = 0; k < 3; k++) { // the face beside B and C
        nodes[4][k] = face[1][k] + (k == 0 ? 2 : 0);
        nodes[5][k] = face[2][k] + (k == 0 ? 2 : 0);
    }
    slave_at(0.3, -0.6, -0.05, nodes[6]);
    const footpoint_nearest_face nearest = {nodes, faces, slaves, distance, which, loc, nullptr};
    nearest(Query{0}, 0);
    check("ArborX: the other face", which[0] == 0 && distance[0] > 0.1 && near(loc[0][0], -1));
    nearest(Query{0}, 1);
    check("ArborX: the nearest face",
          which[0] == 1 && near(distance[0], 0.05) && near(loc[0][0], 0.3) && near(loc[0][1], -0.6));
    nearest(Query{0}, 0);
    check("ArborX: it stays", which[0] == 1);
    slave_at(0.3, -0.6, 5., nodes[6]);
    distance[0] = 10, which[0] = -1;
    nearest(Query{0}, 1);
    check("ArborX: farther away than an edge is long", which[0] == -1 && distance[0] == 10);
}

int main()
{
    tribol_test();
    moose_test();
    nimble_test();
    arborx_test();
    return failures > 0;
}
