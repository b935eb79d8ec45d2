/* Judges the answers of any code to the queries: judge_queries QUERIES ANSWERS NAME [inside].  See README.md. */
#include "query_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RIGHT 1e-10  /* part of q->length: distances within this are equal */
#define PLACED 1e-6  /* of xi and eta, from a closest point */
#define BORDER 1e-12 /* xi and eta may lie beyond the face by rounding */

struct score {
    long asked, right, placed, refused;
};

static int is_on_face(const struct query_text *q, const double loc[2])
{
    if (q->corners == 3)
        return loc[0] >= -BORDER && loc[1] >= -BORDER && loc[0] + loc[1] <= 1 + BORDER;
    return fabs(loc[0]) <= 1 + BORDER && fabs(loc[1]) <= 1 + BORDER;
}

static int is_right(const struct query_text *q, const double loc[2], const double *distance)
{
    const double limit = RIGHT * q->length;
    return is_on_face(q, loc) && fabs((double)(query_distance(q, loc) - q->distance)) <= limit &&
           (!distance || fabs(fabs(*distance) - (double)q->distance) <= limit);
}

static int is_placed(const struct query_text *q, const double loc[2])
{
    for (int i = 0; i < q->minima; i++)
        if (fabs((double)(loc[0] - q->loc[i][0])) <= PLACED && fabs((double)(loc[1] - q->loc[i][1])) <= PLACED)
            return 1;
    return 0;
}

/* Returns 1 if a point that should lie on the face is right: no point there is nearer than the distance. */
static int is_right_point(const struct query_text *q, const double p[3])
{
    const double *const xs = q->x + 3 * q->nodes;
    const double distance = hypot(hypot(p[0] - xs[0], p[1] - xs[1]), p[2] - xs[2]);
    return fabs(distance - (double)q->distance) <= RIGHT * q->length;
}

/* Judges a line; returns 0 if it is not an answer. */
static int judge_line(const struct query_text *q, const char *line, struct score *s)
{
    double loc[2], distance, p[3];
    if (strcmp(line, "skip\n") == 0)
        return 1;
    s->asked++;
    if (strcmp(line, "none\n") == 0) {
        s->refused++;
        return 1;
    }
    if (sscanf(line, "point %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) {
        s->right += is_right_point(q, p);
        return 1;
    }
    const int numbers = sscanf(line, "%lf %lf %lf", &loc[0], &loc[1], &distance);
    if (numbers < 2)
        return 0;
    const int right = is_right(q, loc, numbers == 3 ? &distance : NULL);
    s->right += right;
    s->placed += right && is_placed(q, loc);
    return 1;
}

int main(int argc, char **argv)
{
    if (argc < 4 || argc > 5 || (argc == 5 && strcmp(argv[4], "inside") != 0))
        return fputs("usage: judge_queries QUERIES ANSWERS NAME [inside]\n", stderr), 2;
    FILE *const queries = fopen(argv[1], "r"), *const answers = fopen(argv[2], "r");
    struct score score[QUERY_TEXT_KINDS] = {{0}};
    static const char *const kinds[] = {"tri3", "quad4", "tri6", "quad8", "quad9"};
    struct query_text q;
    char line[200];
    long n = 0;
    int got = 0;
    if (!queries || !answers)
        return perror(queries ? argv[2] : argv[1]), 3;
    while (n++, (got = query_read(queries, &q)) == 1) {
        if (!fgets(line, sizeof line, answers))
            return fprintf(stderr, "%s: error: %ld answers are not enough\n", argv[2], n - 1), 1;
        if ((argc < 5 || q.region == 0) && !judge_line(&q, line, &score[q.index]))
            return fprintf(stderr, "%s:%ld: error: not 'XI ETA [DISTANCE]', 'point X Y Z', 'none' or 'skip'\n", argv[2],
                           n),
                   1;
    }
    if (got < 0)
        return fprintf(stderr, "%s:%ld: error: malformed query\n", argv[1], n), 1;
    if (fgets(line, sizeof line, answers))
        return fprintf(stderr, "%s: error: more than %ld answers\n", argv[2], n - 1), 1;
    puts("search,kind,asked,right,placed,wrong,none");
    for (int k = 0; k < QUERY_TEXT_KINDS; k++) {
        const struct score *const s = &score[k];
        if (s->asked)
            printf("%s,%s,%ld,%ld,%ld,%ld,%ld\n", argv[3], kinds[k], s->asked, s->right, s->placed,
                   s->asked - s->right - s->refused, s->refused);
    }
    return 0;
}
