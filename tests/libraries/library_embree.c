/* Embree: a point query of a four-node face that is split into four triangles about the centre. The library traverses
 * its tree of boxes. The caller computes the closest point of a triangle, as its documentation prescribes. Single
 * precision. */
#include "library.h"

#include "../rivals/four_triangles.h"

#include <embree3/rtcore.h>
#include <float.h>
#include <stdlib.h>

#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)

enum { POINTS = 5, TRIANGLES = 4 };

static const unsigned triangle[TRIANGLES][3] = {{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0}};

struct work {
    RTCScene scene;
    RTCGeometry geometry;
    float *points;
    const double *xs;
    double point[3];
};

static RTCDevice device(void)
{
    static RTCDevice one;
    if (!one)
        one = rtcNewDevice("threads=1,start_threads=0");
    return one;
}

static void *open_scene(int kind)
{
    struct work *const w = calloc(1, sizeof *w);
    (void)kind;
    if (!w)
        return NULL;
    w->scene = rtcNewScene(device());
    w->geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    w->points =
        rtcSetNewGeometryBuffer(w->geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), POINTS);
    unsigned *const index = rtcSetNewGeometryBuffer(w->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                    3 * sizeof(unsigned), TRIANGLES);
    for (int i = 0; i < 3 * TRIANGLES; i++)
        index[i] = triangle[i / 3][i % 3];
    rtcAttachGeometry(w->scene, w->geometry);
    return w;
}

static void set(void *work, const double *x)
{
    struct work *const w = work;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 4; i++)
            w->points[3 * i + k] = (float)x[3 * i + k];
        w->points[12 + k] = (float)(0.25 * (x[k] + x[3 + k] + x[6 + k] + x[9 + k]));
    }
    rtcUpdateGeometryBuffer(w->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(w->geometry);
    rtcCommitScene(w->scene);
}

static bool nearer(struct RTCPointQueryFunctionArguments *args)
{
    struct work *const w = args->userPtr;
    double corner[3][3], v, u, square = 0, p[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            corner[i][k] = (double)w->points[3 * triangle[args->primID][i] + (unsigned)k];
    rival_closest_of_triangle(corner[0], corner[1], corner[2], w->xs, &v, &u);
    for (int k = 0; k < 3; k++) {
        p[k] = corner[0][k] + v * (corner[1][k] - corner[0][k]) + u * (corner[2][k] - corner[0][k]);
        square += (w->xs[k] - p[k]) * (w->xs[k] - p[k]);
    }
    if (!(square < (double)args->query->radius * (double)args->query->radius))
        return false;
    for (int k = 0; k < 3; k++)
        w->point[k] = p[k];
    args->query->radius = (float)__builtin_sqrt(square);
    return true;
}

static int find(void *work, const double xs[3], struct library_answer *a)
{
    struct work *const w = work;
    struct RTCPointQueryContext context;
    struct RTCPointQuery query = {(float)xs[0], (float)xs[1], (float)xs[2], 0, FLT_MAX};
    rtcInitPointQueryContext(&context);
    w->xs = xs;
    query.radius = FLT_MAX / 4;
    if (!rtcPointQuery(w->scene, &query, &context, nearer, w))
        return LIBRARY_NONE;
    a->is_point = 1;
    for (int k = 0; k < 3; k++)
        a->point[k] = w->point[k];
    return LIBRARY_ANSWER;
}

static void close_scene(void *work)
{
    struct work *const w = work;
    rtcReleaseGeometry(w->geometry);
    rtcReleaseScene(w->scene);
    free(w);
}

static const struct library_search searches[] = {{"rtcPointQuery-4", 1u << LIBRARY_QUAD4, LIBRARY_CLOSEST,
                                                  "four triangles about the centre; float", open_scene, set, find,
                                                  close_scene}};

const struct library *library_open(void)
{
    static const struct library self = {"Embree", RTC_VERSION_STRING, 1, searches, 0, NULL};
    return &self;
}
