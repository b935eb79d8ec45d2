/* Float code of segments; see header_float.h.  Products of a dozen and more lengths leave the range of float where
 * edges are 100 long, so that coordinates are first made relative to node A and to the size of the segment.
 *
 * The check is that of runtime/certain/check.h, which explains it, with two differences.  The radius r within which the Hessian
 * is compared is twice the step that Newton's method would make, not the error allowed, where that is more: the same
 * proof, and coarse functions pass, too, where their answer is good.  And rounding errors, 1e9 times those of double,
 * are counted by the lengths that each product consists of, not by their proved bounds, which are ten times as large
 * and would leave little to be sure of. */
#include "header_float.h"

#include "../genome/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const char check[] =
    "/* 1 if a foot point is within `most` of (xi,eta), in xi and in eta, than which no point of the segment is "
    "nearer;\n"
    " * 0 if that is not sure.  In s and t, from 0 to 1: a = r_s, b = r_t, c = r_st, d = xS - r.  Rounding errors "
    "count\n"
    " * as `unit` of the lengths in a product, 5 roundings, about twice what random and hard searches showed: no "
    "proof. */\n"
    "FOOTPOINT_FN int footpoint_detail_f_vouch(const float xA[3], const float xB[3], const float xC[3], const float "
    "xD[3],\n"
    "    const float xS[3], float xi, float eta, float most)\n"
    "{\n"
    "    const float unit = 3e-7f, scale = footpoint_detail_f_quad4_scale(xA, xB, xC, xD);\n"
    "    const float s = 0.5f * (1.0f + xi), t = 0.5f * (1.0f + eta);\n"
    "    float aa = 0.0f, ab = 0.0f, bb = 0.0f, ad = 0.0f, bd = 0.0f, dd = 0.0f, ac = 0.0f, bc = 0.0f, cc = 0.0f;\n"
    "    float cd = 0.0f, reach, la, lb, lc, ld, far, mixed, h12, det, high, both, step_s, step_t, step, r, room, "
    "shift;\n"
    "    float least, less, qs, qt;\n"
    "    int i, near, nearest;\n"
    "    for (i = 0; i < 3; i++) {\n"
    "        const float e = (xB[i] - xA[i]) * scale, g = (xC[i] - xD[i]) * scale;\n"
    "        const float f = (xD[i] - xA[i]) * scale, h = (xC[i] - xB[i]) * scale;\n"
    "        const float a = e + t * (g - e), b = f + s * (h - f), c = g - e;\n"
    "        const float d = (xS[i] - xA[i]) * scale - s * e - t * b;\n"
    "        aa += a * a;\n"
    "        ab += a * b;\n"
    "        bb += b * b;\n"
    "        ad += a * d;\n"
    "        bd += b * d;\n"
    "        dd += d * d;\n"
    "        ac += a * c;\n"
    "        bc += b * c;\n"
    "        cc += c * c;\n"
    "        cd += c * d;\n"
    "    }\n"
    "    reach = fabsf(s) > fabsf(t) ? fabsf(s) : fabsf(t);\n"
    "    reach = reach > 1.0f ? reach : 1.0f;\n"
    "    lc = sqrtf(cc);\n"
    "    la = sqrtf(aa) + reach * lc;\n"
    "    lb = sqrtf(bb) + reach * lc;\n"
    "    ld = sqrtf(dd);\n"
    "    far = ld + reach * (la + lb);\n"
    "    lc += unit * la;\n"
    "    mixed = la * (lb + ld) + lc * far;\n"
    "    h12 = ab - cd;\n"
    "    det = aa * bb - h12 * h12 - 4.0f * unit * mixed * mixed;\n"
    "    high = (aa > bb ? aa : bb) + fabsf(h12);\n"
    "    both = fabsf(ac) + fabsf(bc) + unit * la * (la + lb);\n"
    "    step_s = fabsf(bb * ad - h12 * bd) + unit * (lb * far * mixed + bb * fabsf(ad) + fabsf(h12 * bd));\n"
    "    step_t = fabsf(aa * bd - h12 * ad) + unit * (la * far * mixed + aa * fabsf(bd) + fabsf(h12 * ad));\n"
    "    step = step_s > step_t ? step_s : step_t;\n"
    "    r = 2.0f * step / det;\n"
    "    r = r < 0.5f * most ? r : 0.5f * most;\n"
    "    room = r * (det - 4.0f * r * (both + lc * lc * r) * high);\n"
    "    near = (det > 0.0f) & !(footpoint_detail_f_outside(det) >> 31) & (step_s <= room) & (step_t <= room);\n"
    "    shift = fabsf(ac) * bb + fabsf(bc) * aa + 2.0f * fabsf(h12) * (both + cc) + 4.0f * both * both + cc * (aa + "
    "bb);\n"
    "    least = det - 4.0f * (r * shift + unit * mixed * mixed) * reach;\n"
    "    qt = 2.0f * (bb * ac - h12 * bc);\n"
    "    qs = 2.0f * (aa * bc - h12 * ac);\n"
    "    less = det - 4.0f * (r * shift + unit * la * la * mixed) * reach;\n"
    "    nearest = ((least - qt * t > 0.0f) & (least + qt * (1.0f - t) > 0.0f)) |\n"
    "              ((less - qs * s > 0.0f) & (less + qs * (1.0f - s) > 0.0f));\n"
    "    return near & nearest;\n"
    "}\n";

static void print_scale(const struct segment_kind *k, FILE *out)
{
    char name[4];
    fprintf(out,
            "/* 4 over the sum of the distances of the corners from A, component by component: coordinates relative to "
            "the\n"
            " * segment are those less xA, times this. */\n"
            "FOOTPOINT_FN float footpoint_detail_f_%s_scale(",
            k->name);
    for (size_t i = 0; i < k->corners; i++) {
        segment_vector_name(k, i, name);
        fprintf(out, "%sconst float %s[3]", i == 0 ? "" : i == 3 ? ",\n    " : ", ", name);
    }
    fputs(")\n{\n    return 4.0f / (", out);
    for (size_t i = 1; i < k->corners; i++) {
        segment_vector_name(k, i, name);
        fprintf(out, "%s(fabsf(%s[0] - xA[0]) + fabsf(%s[1] - xA[1]) + fabsf(%s[2] - xA[2]))",
                i == 1 ? "" : " +\n                   ", name, name, name);
    }
    fputs(");\n}\n", out);
}

void single_print_helpers(const struct segment_kind *k, bool checked, FILE *out)
{
    char guard[32];
    snprintf(guard, sizeof guard, "%s", k->name);
    for (char *c = guard; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    fprintf(out, "\n#ifndef FOOTPOINT_%s_SCALE_F\n#define FOOTPOINT_%s_SCALE_F\n", guard, guard);
    print_scale(k, out);
    fputs("#endif\n", out);
    if (checked)
        fprintf(out, "\n#ifndef FOOTPOINT_%s_CHECK_F\n#define FOOTPOINT_%s_CHECK_F\n%s#endif\n", guard, guard, check);
}

void single_print_inputs(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    const size_t nodes = strlen(k->nodes), vectors = segment_vectors(k);
    bool *reads = function_reads(f), scaled = false;
    for (size_t i = 0; f->scaled && i <= vectors; i++) {
        char name[4];
        if ((i >= nodes && i < vectors) || !(reads[3 * i] || reads[3 * i + 1] || reads[3 * i + 2]))
            continue;
        segment_vector_name(k, i, name);
        if (i == 0) {
            fputs("    const float yA[3] = {0.0f, 0.0f, 0.0f};\n", out);
            continue;
        }
        if (!scaled) {
            fprintf(out, "    const float scale = footpoint_detail_f_%s_scale(xA", k->name);
            for (size_t c = 1; c < k->corners; c++)
                fprintf(out, ", x%c", k->nodes[c]);
            fputs(");\n", out);
        }
        scaled = true;
        fprintf(
            out,
            "    const float y%s[3] = {(%s[0] - xA[0]) * scale, (%s[1] - xA[1]) * scale, (%s[2] - xA[2]) * scale};\n",
            name + 1, name, name, name);
    }
    free(reads);
}

bool single_checks(const struct unit *u)
{
    return u->options.samples && !u->file->segment->surface;
}

char *single_worst_name(const struct function *f)
{
    char *name = new_format("%s_WORST", f->name);
    for (char *c = name; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    return name;
}

void single_print_sure(const struct function *f, const char *vectors, FILE *out)
{
    char *worst = single_worst_name(f);
    fprintf(out,
            "{\n    float found[2], g;\n    const int status = %s(%s, found, &g);\n"
            "    if (status != FOOTPOINT_OK)\n        return status;\n"
            "    if (!footpoint_detail_f_vouch(%s, found[0], found[1], %s))\n"
            "        return FOOTPOINT_ERR_DOMAIN;\n"
            "    loc[0] = found[0];\n    loc[1] = found[1];\n    *gap = g;\n    return FOOTPOINT_OK;\n}\n",
            f->name, vectors, vectors, worst);
    free(worst);
}
