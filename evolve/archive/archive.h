/* The best expressions known for each output of each tier: one champion, and the front of error against cost. The start
 * file supplies the first champions; islands' results compete with them. */
#ifndef FOOTPOINT_ARCHIVE_H
#define FOOTPOINT_ARCHIVE_H

#include "../eval/errors.h"
#include "../eval/frame_cost.h"
#include "../eval/objective.h"
#include "../genotype/front.h"
#include "../input/scene.h"
#include "../island/plan.h"

/** The champion of a quest. */
struct champion {
    struct genes genes; /* owned; constants belong to the program, or are decimals in a program; length 0: no champion
                         * yet */
    double error;       /* on the training samples, in the scene's norm */
    double cost;        /* by the plan's model, including the frame's values that it needs */
    bool bred;          /* found by this run */
    bool seed;          /* it was a seed */
    int exact;          /* gene of a frame value that is right to rounding, so that nothing is evolved; 0: no such
                         * value */
    bool chosen;        /* an expression of one gene, chosen among the terminals; nothing is evolved */
    double error_before, cost_before;
    size_t length_before; /* 0: no champion before */
};

/** A quest, a separate search: the programs of a tier or, in a tier of trees, one of its two outputs. */
struct quest {
    const struct tier *own; /* not owned */
    size_t tier;
    int output; /* 0: xi, 1: eta, TIER_BOTH: programs */
    int last;   /* for programs: function that they end in, or -1 */
    struct champion champion;
    struct tails tails;  /* for programs; 0 before archive_measure */
    struct front *front; /* owned; NULL before archive_measure */
    struct front *old;   /* owned: only the start file and the seeds */
};
static inline bool quest_of_programs(const struct quest *q)
{
    return q->own->program;
}

/** An expression to breed from. */
struct archive_seed {
    long tier;          /* -1: every tier that has its symbols */
    int output;         /* 0: xi, 1: eta, 2: both, a program */
    struct genes genes; /* owned; constants are decimal numbers */
};

/** The origin of a front's member. */
enum origin { ORIGIN_START, ORIGIN_SEED, ORIGIN_SEEDED, ORIGIN_RANDOM, ORIGINS };
/** "start file", "seed", "seeded island", "random island". */
extern const char *const origin_name[ORIGINS];

struct archive {
    const struct scene *scene;   /* not owned */
    struct genome_file *program; /* owned: defines the genes; genomes are added on writing */
    char *bare;                  /* owned: text of the program without genomes */
    struct genome_file *start;   /* owned; may be NULL */
    bool knees;                  /* the scene leaves its tiers to the run: only those that knees of the fronts are named
                                  * after have champions */
    bool shipped;                /* the start file belongs to another scene of the same kind: genomes that do not fit
                                  * are skipped */
    struct quest *quest;         /* owned: ordered by tier */
    size_t quests;
    struct archive_seed *seed; /* owned */
    size_t seeds, seed_room;
    struct line_rules *rules;      /* owned: of the program */
    struct lines_counter *counter; /* owned: for programs */
    struct lines *lines;
    struct frame_cost *frame; /* owned; NULL before archive_measure */
};
/** Returns the first of a tier's quests, which are adjacent; *n is 1 or 2. */
struct quest *archive_quests(const struct archive *a, size_t tier, size_t *n);

/** Reads the champions from the genomes of the file `start`, which may be NULL, that are named like tiers. Takes over
 *  the program and adds constants to it, also on failure. Returns NULL with *d filled if the file cannot be read or
 *  uses a symbol that the program lacks. @param[in] shipped  skips genomes with such symbols instead */
struct archive *archive_new(const struct scene *s, struct genome_file *program, const char *start, bool shipped,
                            struct diag *d);
void archive_free(struct archive *a);
/** Returns the start file's genome of a tier, or NULL. */
const struct genome *archive_start_genome(const struct archive *a, size_t tier);

/** Adds a copy of an expression to breed from; its constants must be decimal numbers. */
void archive_add_seed(struct archive *a, long tier, int output, const struct genes *t);
/** Returns false, with *d filled, if a start of a tier of programs is not made of its terminals. */
bool archive_check_starts(const struct archive *a, struct diag *d);
/** Adds every output xi and eta of a genome file as a seed, with constants rounded to decimal numbers, for the tier
 *  named like the genome, or otherwise for all tiers. Returns false, with *d filled, if the file cannot be read, has no
 *  such output, or uses a symbol that the program lacks. */
bool archive_read_seeds(struct archive *a, const char *path, struct diag *d);
/** Finds the seeds from which a quest can breed: the champion, its constants rounded, and added seeds that use only the
 *  tier's terminals and fit its length. Returns their number. The caller frees the array *seed, but the archive owns
 *  its genes. */
size_t archive_seeds(const struct archive *a, const struct quest *q, struct genes **seed);

/** For a tier whose expressions have one gene: adds its terminals as seeds, among which archive_choose_champions
 *  chooses.
 *  @param[in] anew  does so even if there is a champion */
void archive_choose_values(struct archive *a, size_t tier, bool anew);

/** Returns true if both outputs of a tier are frame values that are right to rounding. */
bool archive_is_exact(const struct archive *a, size_t tier);

/** Finds terminals that are right within `tolerance` on every training sample and within their tier's budget. The
 *  cheapest becomes a seed, which archive_measure makes the champion.
 *  @param[in] table  columns of the training samples */
void archive_find_exact(struct archive *a, const struct plan *plan, const struct columns *table, double tolerance);
/** Prints the tiers that need no evolution, as the end of a line. */
void archive_print_exact(const struct archive *a, FILE *stream);

/** Measures the champions and starts the fronts with champions and seeds.
 *  @param[in] o  must use decimal numbers */
void archive_measure(struct archive *a, const struct plan *plan, struct objective *o);

/** Returns the genes of a tier: its terminals and functions, the paper's 201 constants -5.00..5.00 in steps of 0.05,
 *  and the rounded constants of the tier's champions.
 *  @param[in] rational  adds quotients to + - * if the tier lists no functions; for trees, protected quotients */
struct gene_set archive_genes(const struct archive *a, size_t tier, bool rational);

/** Returns the genes of a tier's terminals, owned by the caller. */
int *archive_symbols(const struct archive *a, size_t tier);
/** Returns the error in the objective's norm. */
double archive_bare_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t);
/** Returns the error that islands minimise, which for programs includes the charge for their tails. */
double archive_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t);

/** Counts the operations of a tree, or of a program with the frame's values that it needs. */
struct operation_count archive_operations(const struct archive *a, const struct quest *q, const struct genes *t,
                                          const struct genome_constant *constant);

/** Offers genes with decimal constants to the quest's front. */
void archive_offer(const struct archive *a, const struct plan *plan, struct quest *q, const struct genes *t,
                   double error, enum origin origin);
/** Replaces champions by members of the fronts. If the tier has a budget, the lowest error within it wins, provided
 *  that it is lower than the champion's or the champion exceeds the budget. Otherwise the lowest fitness by the plan
 *  wins, if it is lower than the champion's and the error is not higher. "Lower" means by one in a hundred, or one in
 *  ten for programs that a judge compares; smaller gains change no header. @param[in] o      of the training samples
 *  @param[in] judge  of the validation samples, on which programs are compared, so that overfitted programs are
 *  rejected;
 *                     NULL: compares programs on the training samples, like trees */
void archive_choose_champions(struct archive *a, const struct plan *plan, struct objective *o, struct objective *judge);

/** Replaces the champion of a quest by a member of a front. */
void archive_replace_champion(const struct archive *a, struct objective *o, struct quest *q, const struct member *m);

/** Replaces champions by at most six members at the knees of all fronts, where the error drops most for its cost, both
 *  in logarithms. No member has a figure on the judge's samples that is worse than that of the most accurate shipped
 *  function of its price. A member is named after a shipped function whose mean error it equals, and nearly its largest;
 *  the other tiers lose their champions. All tiers must compose alike.
 *  @param[in] shipped  the functions of the kind of face, measured */
void archive_choose_knees(struct archive *a, const struct archive *shipped, struct objective *o,
                          struct objective *judge);

/** Returns false if no expression of the tier has a finite error on every sample. Such a tier is not written. */
bool archive_has(const struct archive *a, size_t tier);

/** Finds members of a tier of programs that may become tiers, by ascending cost: members within the budget or slightly
 *  above it, each better on the judge's samples than all cheaper members. Keeps the `most` most expensive of them and
 *  returns their number. @param[out] found  must have room for the front's limit + 1 */
size_t archive_members(const struct archive *a, struct objective *judge, const struct quest *q, size_t most,
                       const struct member **found);

#endif
