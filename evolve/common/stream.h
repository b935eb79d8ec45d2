/* Random streams keyed by their purpose, so that no random number depends on ranks, threads, order or time. */
#ifndef FOOTPOINT_STREAM_H
#define FOOTPOINT_STREAM_H

#include <gsl/gsl_rng.h>
#include <stdint.h>

/** Returns a generator for all gsl_rng_ and gsl_ran_ functions, which must be keyed before use. Free with gsl_rng_free(). */
gsl_rng *stream_new(void);

/** Starts the stream of (seed, a, b, c), for instance (seed, island, generation, individual), in a few nanoseconds.  Equal
 *  keys give equal streams on every machine; different keys give unrelated streams. */
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
