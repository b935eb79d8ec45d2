/* What a checkpoint of a run holds, how all ranks write it, and how a run goes on from it: facts (version, scene,
 * options, generation, log), the genomes that the run started from, and the state of every island. */
#ifndef FOOTPOINT_RESUME_H
#define FOOTPOINT_RESUME_H

#include "checkpoint.h"
#include "islands.h"
#include "run_log.h"

/** Sections before those of the islands: the start file, empty where there was none. */
enum { RESUME_START, RESUME_ISLANDS };

/** The checkpoints that a run writes. */
struct saving {
    const struct team *team; /* not owned, as are these */
    const struct islands *islands;
    const char *path;
    const char *start; /* on rank 0: the genomes */
    size_t *bytes;     /* owned: of each section */
};
/** Collective: s->bytes from the rest of *s; the genomes have so many bytes. */
void saving_prepare(struct saving *s, size_t start_bytes);
/** Collective: write a checkpoint of all islands as they are, with rank 0's facts.  It replaces the one of before when
 *  all ranks have written their part; until then, and where one could not, which gives false with *d on all, that one
 *  stays. */
bool saving_write(const struct saving *s, const char *facts, struct diag *d);

struct resume {
    const char *path; /* not owned */
    struct checkpoint file;
    char *start; /* owned: text of the genomes, empty for none */
    size_t generation;
    struct log_mark mark; /* 0 bytes: there was no log */
};

enum { FACTS = 16384 };
/** The facts of a run at a generation but for its options, into text[0..FACTS-1]. */
void resume_facts(char text[FACTS], const char *scene_sha256, const char *frames_sha256, size_t generation,
                  const struct log_mark *mark);

/** Collective: read on rank 0 and told to all.  False with *d: unreadable, damaged, or of another version or machine.
 */
bool resume_read(struct resume *r, const struct team *t, const char *path, struct diag *d);
/** False with *d if the checkpoint is of another scene. */
bool resume_suits(const struct resume *r, const char *scene_sha256, size_t generations, struct diag *d);
/** False with *d if its genes are of other frames, or of other tiers of the kind. */
bool resume_suits_frames(const struct resume *r, const char *frames_sha256, struct diag *d);
/** Collective: load all islands, each rank its own.  False with *d where a section is damaged, or no state of its
 *  island. */
bool resume_islands(const struct resume *r, const struct team *t, const struct islands *s, struct diag *d);
/** Write the genomes aside, for a reader of files: path[0..n-1], to be removed by the caller. */
bool resume_start_file(const struct resume *r, char *path, size_t n, struct diag *d);
void resume_free(struct resume *r);

#endif
