/* Random streams keyed by what they are for, so that nothing random depends on ranks, threads, order or time. */
#ifndef FOOTPOINT_STREAM_H
#define FOOTPOINT_STREAM_H

#include <gsl/gsl_rng.h>
#include <stdint.h>

/** A generator for all gsl_rng_ and gsl_ran_ functions; key it before use. Free with gsl_rng_free(). */
gsl_rng *stream_new(void);

/** Start the stream of (seed, a, b, c), for instance (seed, island, generation, individual): a few nanoseconds.  Equal
 *  keys give equal streams on every machine; different keys give unrelated ones. */
void stream_key(gsl_rng *stream, uint64_t seed, uint64_t a, uint64_t b, uint64_t c);

enum { TAPE_NUMBERS = 128 };
/** The first numbers of a stream. */
struct stream_tape {
    uint64_t number[TAPE_NUMBERS];
    size_t n;
};
/** Plays a tape from its beginning: the stream returns the tape's numbers first, then draws its own and appends these to the
 *  tape while there is room.  An empty tape therefore records.  NULL ends playing. */
void stream_play(gsl_rng *stream, struct stream_tape *tape);

#endif
