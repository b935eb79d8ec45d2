/* Checkpoints of a run: how all ranks write it, and how a run resumes from it. It contains facts (version, scene,
 * options, generation, log), the genomes from which the run started, and the state of every island. */
#ifndef FOOTPOINT_RESUME_H
#define FOOTPOINT_RESUME_H

#include "checkpoint.h"
#include "islands.h"
#include "run_log.h"

/** The sections before the islands': the start file, which may be empty. */
enum { RESUME_START, RESUME_ISLANDS };

/** The checkpoints that a run writes. */
struct saving {
    const struct team *team; /* not owned */
    const struct islands *islands;
    const char *path;
    const char *start; /* on rank 0: the genomes */
    size_t *bytes;     /* owned: of each section */
};
/** Sets s->bytes from the rest of *s and the size of the start genomes. Collective. */
void saving_prepare(struct saving *s, size_t start_bytes);
/** Writes a checkpoint of all islands, with rank 0's facts. Collective. It replaces the previous checkpoint once all
 *  ranks have written their part. If a rank fails, the previous one stays, and all ranks return false with *d. */
bool saving_write(const struct saving *s, const char *facts, struct diag *d);

struct resume {
    const char *path; /* not owned */
    struct checkpoint file;
    char *start; /* owned: text of the genomes; may be empty */
    size_t generation;
    struct log_mark mark; /* 0 bytes: there was no log */
};

enum { FACTS = 16384 };
/** Writes the facts of a run at a generation, except its options, to text[0..FACTS-1]. */
void resume_facts(char text[FACTS], const char *scene_sha256, const char *frames_sha256, size_t generation,
                  const struct log_mark *mark);

/** Reads a checkpoint on rank 0 and sends it to all. Collective. Returns false with *d if it is unreadable, damaged, or
 *  of another version or machine. */
bool resume_read(struct resume *r, const struct team *t, const char *path, struct diag *d);
/** Returns false with *d if the checkpoint belongs to another scene. */
bool resume_suits(const struct resume *r, const char *scene_sha256, size_t generations, struct diag *d);
/** Returns false with *d if its genes belong to other frames, or to other tiers of the kind. */
bool resume_suits_frames(const struct resume *r, const char *frames_sha256, struct diag *d);
/** Loads all islands, each rank its own. Collective. Returns false with *d if a section is damaged or does not fit its
 *  island. */
bool resume_islands(const struct resume *r, const struct team *t, const struct islands *s, struct diag *d);
/** Writes the genomes to a temporary file, path[0..n-1], which the caller must remove. */
bool resume_start_file(const struct resume *r, char *path, size_t n, struct diag *d);
void resume_free(struct resume *r);

#endif
