/* Random node normals on the paper's configurations; see lattice_normals.h. */
#include "lattice_normals.h"

#include "../common/stream.h"
#include "../common/vec3.h"
#include "../surface/foot_patch.h"
#include "source.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

static void normalise(double v[3])
{
    const double length = vector_length(v);
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

/* Computes the facet's unit normal at corner c, and two unit vectors that complete the basis. */
static void corner_basis(double x[4][3], int c, double n[3], double e1[3], double e2[3])
{
    double next[3], last[3];
    for (int k = 0; k < 3; k++) {
        next[k] = x[(c + 1) % 4][k] - x[c][k];
        last[k] = x[(c + 3) % 4][k] - x[c][k];
    }
    vector_cross(next, last, n);
    normalise(n);
    memcpy(e1, next, 3 * sizeof *e1);
    normalise(e1);
    vector_cross(n, e1, e2);
}

void draw_normals(gsl_rng *stream, double tangent, struct sample *s)
{
    for (int c = 0; c < 4; c++) {
        double n[3], e1[3], e2[3], *normal = s->x[PATCH_NORMALS + c];
        const double tilt = tangent * sqrt(gsl_rng_uniform(stream)), turn = 2 * M_PI * gsl_rng_uniform(stream);
        corner_basis(s->x, c, n, e1, e2);
        for (int k = 0; k < 3; k++)
            normal[k] = n[k] + tilt * (cos(turn) * e1[k] + sin(turn) * e2[k]);
        normalise(normal);
    }
}

bool lattice_gregory_samples(const struct lattice_gregory *l, enum sample_part part, struct sample_set *set,
                             struct lattice_gregory_count *count, struct diag *d)
{
    struct sample_set facets = {0};
    double lo[2], hi[2];
    if (!lattice_grid(l->scene, part, &facets, d)) {
        sample_set_free(&facets);
        return false;
    }
    gsl_rng *stream = stream_new();
    const size_t configurations = l->configurations ? GSL_MIN(l->configurations, facets.n) : facets.n;
    const size_t sets = (size_t)l->normal_sets, before = set->n;
    scene_box(l->scene, lo, hi);
    for (size_t i = 0; i < configurations; i++)
        for (size_t k = 0; k < sets; k++) {
            struct sample s = facets.s[i];
            stream_key(stream, l->scene->seed, (uint64_t)part, i, 1 + k);
            draw_normals(stream, l->tangent, &s);
            if (foot_patch(l->kind, &s, lo, hi, (double[]){s.xi, s.eta}))
                sample_set_add(set, &s);
        }
    if (count)
        *count = (struct lattice_gregory_count){configurations, configurations * sets, set->n - before};
    gsl_rng_free(stream);
    sample_set_free(&facets);
    return true;
}
