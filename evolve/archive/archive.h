/* The best expressions known for each output of each tier: one champion, and the front of error against cost.  Read
 * from the start file, challenged by what the islands find. */
#ifndef FOOTPOINT_ARCHIVE_H
#define FOOTPOINT_ARCHIVE_H

#include "../eval/errors.h"
#include "../eval/frame_cost.h"
#include "../eval/objective.h"
#include "../genotype/front.h"
#include "../input/scene.h"
#include "../island/plan.h"

/** What is known of one quest. */
struct champion {
    struct genes genes; /* genes owned, constants are the program's, or decimals of a program; length 0: none yet */
    double error;       /* on the training samples, in the scene's norm */
    double cost;        /* by the plan's model, with the values of the frame that it needs */
    bool bred;          /* found by this run */
    bool seed;          /* and was a seed */
    int exact;          /* gene of a value of the frame that is right to rounding: nothing to evolve; 0: none */
    bool chosen;        /* an expression of one gene, chosen among the terminals: nothing to evolve */
    double error_before, cost_before;
    size_t length_before; /* 0: there was none */
};

/** What is bred for by itself: the programs of a tier, or, of a tier of trees, one output of the two. */
struct quest {
    const struct tier *own; /* not owned */
    size_t tier;
    int output; /* 0: xi, 1: eta, TIER_BOTH: programs */
    int last;   /* of programs: the function that they end in; -1: none */
    struct champion champion;
    struct tails tails;  /* of programs; 0 before archive_measure */
    struct front *front; /* owned; NULL before archive_measure */
    struct front *old;   /* owned: the start file and the seeds alone */
};
static inline bool quest_of_programs(const struct quest *q)
{
    return q->own->program;
}

/** An expression to breed from. */
struct archive_seed {
    long tier;          /* -1: every tier that has its symbols */
    int output;         /* 0: xi, 1: eta, 2: both, a program */
    struct genes genes; /* genes owned; constants are decimal numbers */
};

/** Where a member of a front comes from. */
enum origin { ORIGIN_START, ORIGIN_SEED, ORIGIN_SEEDED, ORIGIN_RANDOM, ORIGINS };
/** "start file", "seed", "seeded island", "random island". */
extern const char *const origin_name[ORIGINS];

struct archive {
    const struct scene *scene;   /* not owned */
    struct genome_file *program; /* owned: what the genes mean; the genomes are added on writing */
    char *bare;                  /* owned: the program's text before that */
    struct genome_file *start;   /* owned; NULL: none */
    bool shipped;                /* it is another scene's, of the same kind: what suits is taken */
    struct quest *quest;         /* owned: tier by tier */
    size_t quests;
    struct archive_seed *seed; /* owned */
    size_t seeds, seed_room;
    struct line_rules *rules;      /* owned: of the program */
    struct lines_counter *counter; /* owned: of programs, as is the scratch */
    struct lines *lines;
    struct frame_cost *frame; /* owned; NULL before archive_measure */
};
/** A tier's quests, one or two that follow each other; returns the first. */
struct quest *archive_quests(const struct archive *a, size_t tier, size_t *n);

/** Champions of the file `start`; none where it is NULL or has no genome of a tier's name.  Takes the program over (and
 *  adds constants to it) even when it returns NULL, with *d filled: the file cannot be read or uses a symbol that the
 *  program lacks.
 *  @param[in] shipped  genomes with such symbols are passed over */
struct archive *archive_new(const struct scene *s, struct genome_file *program, const char *start, bool shipped,
                            struct diag *d);
void archive_free(struct archive *a);
/** The start file's genome of a tier, or NULL. */
const struct genome *archive_start_genome(const struct archive *a, size_t tier);

/** Add a copy of an expression to breed from; its constants are decimal numbers. */
void archive_add_seed(struct archive *a, long tier, int output, const struct genes *t);
/** False with *d where a start of a tier of programs is not made of its terminals. */
bool archive_check_starts(const struct archive *a, struct diag *d);
/** Add every output xi and eta of a genome file as a seed, with constants rounded to decimal numbers, for the tier that
 *  has the genome's name, or else for all.  False with *d filled if the file cannot be read, has no such output, or
 *  uses a symbol that the program lacks. */
bool archive_read_seeds(struct archive *a, const char *path, struct diag *d);
/** The seeds of a quest that may breed: the champion (its constants rounded) and those added, as far as they use the
 *  tier's terminals alone and are not too long.  Returns how many; *seed is an array for the caller to free, of trees
 *  that the archive owns. */
size_t archive_seeds(const struct archive *a, const struct quest *q, struct genes **seed);

/** Expressions of a tier are of one gene: its terminals become seeds, so that archive_choose_champions chooses among
 *  them.
 *  @param[in] anew  also where there is a champion */
void archive_choose_values(struct archive *a, size_t tier, bool anew);

/** Both outputs of a tier are values of the frame that are right to rounding. */
bool archive_is_exact(const struct archive *a, size_t tier);

/** Look for terminals that are right to `tolerance` on every training sample and within their tier's budget.  The
 *  cheapest becomes a seed, and archive_measure will make it the champion.
 *  @param[in] table  columns of the training samples */
void archive_find_exact(struct archive *a, const struct plan *plan, const struct columns *table, double tolerance);
/** The end of a line: which tiers need nothing evolved. */
void archive_print_exact(const struct archive *a, FILE *stream);

/** Measure the champions that were read, and found the fronts with champions and seeds.
 *  @param[in] o  objective of decimal numbers */
void archive_measure(struct archive *a, const struct plan *plan, struct objective *o);

/** The genes of a tier: its terminals and functions, the paper's 201 constants -5.00..5.00 in steps of 0.05 and,
 * rounded, those of the tier's champions.
 *  @param[in] rational  quotients beside + - *, where the tier lists no functions; of trees, protected ones */
struct gene_set archive_genes(const struct archive *a, size_t tier, bool rational);

/** Genes of a tier's terminals; owned by the caller. */
int *archive_symbols(const struct archive *a, size_t tier);
/** The error in the objective's norm. */
double archive_bare_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t);
/** The error that islands minimise: that of a program is charged for its tails. */
double archive_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t);

/** Operations of a tree; of a program with the values of the frame that it needs. */
struct operation_count archive_operations(const struct archive *a, const struct quest *q, const struct genes *t,
                                          const struct genome_constant *constant);

/** Offer genes of decimal constants to the quest's front. */
void archive_offer(const struct archive *a, const struct plan *plan, struct quest *q, const struct genes *t,
                   double error, enum origin origin);
/** Let members of the fronts take the champions' places.  Where the tier has a budget: the lowest error within it, if
 *  that is lower than the champion's or the champion exceeds it.  Otherwise: the lowest fitness by the plan, if it is
 *  lower than the champion's and the error is not higher.  Lower means by one in a hundred, of programs that a judge
 *  compares by one in ten: less changes no header.
 *  @param[in] o      of the training samples
 *  @param[in] judge  of the validation samples, whose errors programs are chosen by: what fits the training samples
 *                    alone is not taken; NULL: as trees, by the training samples */
void archive_choose_champions(struct archive *a, const struct plan *plan, struct objective *o, struct objective *judge);

/** False if there is no expression for the tier: none had a finite error on every sample.  It is left out of what is
 *  written. */
bool archive_has(const struct archive *a, size_t tier);

/** Members of a tier of programs that may become tiers, by cost: those near its budget or below, each better on the
 *  judge's samples than all cheaper ones, and of these the `most` dearest; returns how many.
 *  @param[out] found  room for the front's limit + 1 */
size_t archive_members(const struct archive *a, struct objective *judge, const struct quest *q, size_t most,
                       const struct member **found);

#endif
