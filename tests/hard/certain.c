/* Judges certain answers by the million: footpoint_robust, _stationary, _locate, _certify, _select_closest and attach_2d_ are
 * called once a case, the last with 3, 4, 6 and 8 nodes in turn.  The judges are in judges.c and judge_faces.c. */
#include "certain.h"

#include "judges.h"

#include <stdio.h>
#include <string.h>

enum { SHOWN = 3, SEGMENTS = 6, CHECK_EACH = 16 };
enum function { ROBUST, STATIONARY, LOCATE, CERTIFY, SELECT, ATTACH3, ATTACH4, ATTACH6, ATTACH8, FUNCTIONS };

static const char *const name_of[FUNCTIONS] = {"robust",  "stationary", "locate",  "certify", "select",
                                               "attach3", "attach4",    "attach6", "attach8"};

/* Several truths would overflow the stack. */
struct bench {
    struct hard_case h[SEGMENTS], triangle;
    struct truth truth[SEGMENTS], of_triangle;
    struct tally tally[FUNCTIONS];
    long undecided, contradicted;
};

static void print_case(const struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        printf("#   {%a, %a, %a}\n", h->x[i][0], h->x[i][1], h->x[i][2]);
}

/* Draws another case of the family, moved so that its corner `at` is corner `to` of the first. */
static void draw_neighbour(int family, uint64_t seed, uint64_t index, int k, int at, int to, struct bench *b)
{
    struct hard_case *const h = &b->h[k];
    hard_draw(family, seed + 0x9e3779b9u * (uint64_t)k, index, h);
    for (int i = 0; i < 3; i++) {
        const double by = b->h[0].x[to][i] - h->x[at][i];
        for (int n = 0; n < 4; n++)
            h->x[n][i] += by;
    }
    memcpy(h->x[at], b->h[0].x[to], sizeof h->x[at]);
    memcpy(h->x[4], b->h[0].x[4], sizeof h->x[4]);
}

static void select_case(int family, uint64_t seed, uint64_t index, struct bench *b)
{
    const int count = 2 + (int)(index % (SEGMENTS - 1));
    int at[SEGMENTS] = {(int)(index / 7 % 4)};
    for (int k = 1; k < count; k++) {
        at[k] = (int)((index / 3 + (uint64_t)k) % 4);
        draw_neighbour(family, seed, index, k, at[k], at[0], b);
        truth_find(&b->h[k], TRUTH_NEAREST, &b->truth[k]);
        b->undecided += !b->truth[k].decided;
        if (b->truth[k].count == 0)
            return;
    }
    judge_select(b->h, at, count, b->truth, &b->tally[SELECT]);
}

static void attach_case(uint64_t index, struct bench *b)
{
    static const int nodes[4] = {3, 4, 6, 8};
    const int which = (int)(index % 4), corners = which % 2 ? 4 : 3;
    const struct truth *t = &b->truth[0];
    if (corners == 3) {
        b->triangle = b->h[0];
        memcpy(b->triangle.x[3], b->triangle.x[2], sizeof b->triangle.x[3]);
        truth_find(&b->triangle, TRUTH_NEAREST, &b->of_triangle);
        t = &b->of_triangle;
    }
    if (t->count > 0)
        judge_attach(&b->h[0], nodes[which], t, &b->tally[ATTACH3 + which]);
}

static void run_case(const struct hard_family *f, int family, uint64_t seed, uint64_t index, struct bench *b)
{
    struct tally *const a = b->tally;
    struct truth *const t = &b->truth[0];
    hard_draw(family, seed, index, &b->h[0]);
    if (!f->finite) {
        judge_not_finite(&b->h[0], &a[ROBUST], &a[STATIONARY], &a[LOCATE]);
        return;
    }
    truth_find(&b->h[0], index % CHECK_EACH == 0 ? TRUTH_CHECKED : TRUTH_ALL, t);
    b->undecided += !t->decided;
    b->contradicted += t->contradicted;
    judge_robust(&b->h[0], t, &a[ROBUST]);
    judge_stationary(&b->h[0], t, &a[STATIONARY]);
    judge_locate(&b->h[0], t, &a[LOCATE]);
    judge_certify(&b->h[0], 0x9e3779b97f4a7c15u * (index + 1) + seed, &a[CERTIFY]);
    if (!f->sized || t->count == 0)
        return;
    select_case(family, seed, index, b);
    attach_case(index, b);
}

static long sum_wrong(const struct tally *a)
{
    return a->wrong + a->wrong_status;
}

static void run_family(int family, long n, uint64_t seed, long first, struct bench *b)
{
    memset(b, 0, sizeof *b);
    for (long i = first; i < first + n; i++) {
        long before[FUNCTIONS];
        const long odd = b->contradicted;
        for (int k = 0; k < FUNCTIONS; k++)
            before[k] = sum_wrong(&b->tally[k]);
        run_case(&hard_families[family], family, seed, (uint64_t)i, b);
        for (int k = 0; k < FUNCTIONS; k++)
            if (sum_wrong(&b->tally[k]) > before[k] && before[k] < SHOWN) {
                printf("# %s %ld, seed %lu, %s: %s\n", hard_families[family].name, i, (unsigned long)seed, name_of[k],
                       b->tally[k].why);
                print_case(&b->h[0]);
            }
        if (b->contradicted > odd && odd < SHOWN) {
            printf("# %s %ld, seed %lu: the truth is not proved\n", hard_families[family].name, i, (unsigned long)seed);
            print_case(&b->h[0]);
        }
    }
}

static void print_line(const char *family, const char *function, const struct tally *a)
{
    printf("%s,%s,%ld,%ld,%ld,%ld,%ld,%ld,%.1e,%ld,%ld\n", family, function, a->calls, a->answered, a->outside,
           a->not_unique, a->unproved, a->refused, a->worst, a->wrong, a->wrong_status);
}

int certain_run(long n, uint64_t seed, long first, const char *only)
{
    static struct bench b;
    struct tally all[FUNCTIONS] = {{0}};
    long undecided = 0, contradicted = 0, wrong = 0;
    printf("family,method,n,ok,outside,not_unique,unproved,refused,worst,wrong,wrong_status\n");
    for (int family = 0; family < hard_family_count; family++) {
        const char *const name = hard_families[family].name;
        if (only && strcmp(only, name) != 0)
            continue;
        run_family(family, only ? n : (n + hard_family_count - 1) / hard_family_count, seed, first, &b);
        for (int k = 0; k < FUNCTIONS; k++) {
            const struct tally *const a = &b.tally[k];
            print_line(name, name_of[k], a);
            all[k].calls += a->calls;
            all[k].answered += a->answered;
            all[k].outside += a->outside;
            all[k].not_unique += a->not_unique;
            all[k].unproved += a->unproved;
            all[k].refused += a->refused;
            all[k].wrong += a->wrong;
            all[k].wrong_status += a->wrong_status;
            all[k].worst = a->worst > all[k].worst ? a->worst : all[k].worst;
        }
        if (b.undecided + b.contradicted > 0)
            printf("# %s: truth undecided in %ld, in error in %ld\n", name, b.undecided, b.contradicted);
        fflush(stdout);
        undecided += b.undecided;
        contradicted += b.contradicted;
    }
    for (int k = 0; k < FUNCTIONS; k++) {
        print_line("all", name_of[k], &all[k]);
        wrong += sum_wrong(&all[k]);
    }
    printf("# truth: undecided %ld, in error %ld\n", undecided, contradicted);
    return wrong == 0 && contradicted == 0;
}
