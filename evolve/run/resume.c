/* Checkpoints of a run; see resume.h. */
#include "resume.h"

#include "../../codegen/base/outfile.h"
#include "../mpi/shared_file.h"

#include <endian.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The machine, because states are its raw bytes. */
static const char *const machine = BYTE_ORDER == LITTLE_ENDIAN ? "little-endian" : "big-endian";

void resume_facts(char text[FACTS], const char *scene_sha256, const char *frames_sha256, size_t generation,
                  const struct log_mark *mark)
{
    snprintf(text, FACTS,
             "version %s\nmachine %s\nscene-sha256 %s\nframes-sha256 %s\ngeneration %zu\nlog-mark %" PRIu64 " %s\n",
             FOOTPOINT_VERSION, machine, scene_sha256, frames_sha256, generation, mark->bytes, mark->sha256);
}

void saving_prepare(struct saving *s, size_t start_bytes)
{
    s->bytes = new_array(islands_count(s->islands) + RESUME_ISLANDS, sizeof *s->bytes);
    s->bytes[RESUME_START] = s->team->rank == 0 ? start_bytes : 0;
    team_sum(s->team, s->bytes, RESUME_ISLANDS);
    islands_sizes(s->islands, s->team, island_state_size, s->bytes + RESUME_ISLANDS);
}

static bool write_section(struct shared_file *f, const struct checkpoint *c, size_t i, unsigned char *data,
                          struct diag *d)
{
    const struct checkpoint_part *part = &c->section[i];
    checkpoint_seal(data, part->bytes);
    return shared_file_write(f, part->place, data, part->bytes + CHECKPOINT_SEAL, d);
}

/* Writes the sections of this rank's islands. */
static bool write_sections(const struct saving *s, const struct checkpoint *c, struct shared_file *f, struct diag *d)
{
    size_t most = s->bytes[RESUME_START];
    for (size_t i = 0; i < islands_count(s->islands); i++)
        if (s->islands->island[i] && s->bytes[i + RESUME_ISLANDS] > most)
            most = s->bytes[i + RESUME_ISLANDS];
    unsigned char *data = new_array(most + CHECKPOINT_SEAL, 1);
    bool good = true;
    if (s->team->rank == 0) {
        memcpy(data, s->start, s->bytes[RESUME_START]);
        good = shared_file_write(f, 0, c->head, c->head_bytes, d) && write_section(f, c, RESUME_START, data, d);
    }
    for (size_t i = 0; good && i < islands_count(s->islands); i++)
        if (s->islands->island[i]) {
            island_save(s->islands->island[i], data);
            good = write_section(f, c, i + RESUME_ISLANDS, data, d);
        }
    free(data);
    return good;
}

/* Writes the file under a temporary name, on all ranks. Collective. */
static bool write_aside(const struct saving *s, const char *facts, const char *aside, struct diag *d)
{
    struct shared_file f = {.path = s->path};
    if (!shared_file_open(&f, s->team, aside, d))
        return false;
    struct checkpoint c = checkpoint_new(facts, s->bytes, islands_count(s->islands) + RESUME_ISLANDS);
    bool good = write_sections(s, &c, &f, d);
    struct diag closing;
    if (!shared_file_close(&f, &closing) && good) {
        *d = closing;
        good = false;
    }
    checkpoint_free(&c);
    return team_agree(s->team, good, d);
}

bool saving_write(const struct saving *s, const char *facts, struct diag *d)
{
    const bool first = s->team->rank == 0;
    struct outfile file;
    bool good = !first || outfile_open(&file, s->path, d);
    if (!team_agree(s->team, good, d))
        return false;
    const char *path = !first ? NULL : *file.aside ? file.aside : file.target;
    char *aside = team_tell(s->team, path, first ? strlen(path) : 0);
    char *told = team_tell(s->team, facts, first ? strlen(facts) : 0);
    good = write_aside(s, told, aside, d);
    if (first && good)
        good = outfile_commit(&file, d);
    else if (first)
        outfile_discard(&file);
    free(aside);
    free(told);
    return team_agree(s->team, good, d);
}

static bool known(struct resume *r, struct diag *d)
{
    char value[128], rest;
    if (!checkpoint_fact(r->file.facts, "version", value, sizeof value) || strcmp(value, FOOTPOINT_VERSION) != 0)
        return diag_at(d, r->path, 0, 0, "checkpoint has version %s; this program has %s", value, FOOTPOINT_VERSION);
    if (!checkpoint_fact(r->file.facts, "machine", value, sizeof value) || strcmp(value, machine) != 0)
        return diag_at(d, r->path, 0, 0, "checkpoint is from a %s machine; this machine is %s", value, machine);
    if (!checkpoint_fact(r->file.facts, "generation", value, sizeof value) ||
        sscanf(value, "%zu%c", &r->generation, &rest) != 1 ||
        !checkpoint_fact(r->file.facts, "log-mark", value, sizeof value) ||
        sscanf(value, "%" SCNu64 " %64s", &r->mark.bytes, r->mark.sha256) != 2)
        return diag_at(d, r->path, 0, 0, "checkpoint lacks its generation");
    return true;
}

bool resume_read(struct resume *r, const struct team *t, const char *path, struct diag *d)
{
    const bool first = t->rank == 0;
    *r = (struct resume){.path = path};
    if (!team_agree(t, !first || checkpoint_read(&r->file, path, d), d))
        return false;
    char *head = team_tell(t, r->file.head, r->file.head_bytes);
    bool good = first || checkpoint_take(&r->file, path, head, d);
    free(head);
    good = good && (r->file.sections >= RESUME_ISLANDS || diag_at(d, path, 0, 0, "checkpoint lacks its start genomes"));
    unsigned char *start = good && first ? checkpoint_section(&r->file, path, RESUME_START, d) : NULL;
    if (team_agree(t, good && (!first || start), d))
        r->start = team_tell(t, (const char *)start, first ? r->file.section[RESUME_START].bytes : 0);
    free(start);
    return r->start && team_agree(t, known(r, d), d);
}

/* Returns false with *d if a digest of the checkpoint is not this one. */
static bool same_digest(const struct resume *r, const char *key, const char *sha256, const char *other, struct diag *d)
{
    char stored[65] = "";
    checkpoint_fact(r->file.facts, key, stored, sizeof stored);
    return strcmp(stored, sha256) == 0 ||
           diag_at(d, r->path, 0, 0, "checkpoint belongs to %s: SHA-256 %.12s..., not %.12s...", other, stored, sha256);
}

bool resume_suits(const struct resume *r, const char *scene_sha256, size_t generations, struct diag *d)
{
    if (!same_digest(r, "scene-sha256", scene_sha256, "another scene", d))
        return false;
    if (generations >= r->generation)
        return true;
    diag_at(d, r->path, 0, 0, "checkpoint is at generation %zu, beyond --generations %zu", r->generation, generations);
    d->code = EXIT_USAGE;
    return false;
}

bool resume_suits_frames(const struct resume *r, const char *frames_sha256, struct diag *d)
{
    return same_digest(r, "frames-sha256", frames_sha256, "other frames", d);
}

bool resume_islands(const struct resume *r, const struct team *t, const struct islands *s, struct diag *d)
{
    const size_t n = islands_count(s);
    bool good = r->file.sections == n + RESUME_ISLANDS || diag_at(d, r->path, 0, 0, "checkpoint lacks islands");
    for (size_t i = 0; good && i < n; i++) {
        if (!s->island[i])
            continue;
        unsigned char *state = checkpoint_section(&r->file, r->path, i + RESUME_ISLANDS, d);
        const bool whole = state && r->file.section[i + RESUME_ISLANDS].bytes == island_state_size(s->island[i]);
        good = state && ((whole && island_load(s->island[i], state)) ||
                         diag_at(d, r->path, 0, 0, "island %zu of the checkpoint is malformed", i));
        free(state);
    }
    return team_agree(t, good, d);
}

bool resume_start_file(const struct resume *r, char *path, size_t n, struct diag *d)
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, n, "%s/footpoint-start-XXXXXX", folder ? folder : "/tmp");
    const int file = mkstemp(path);
    FILE *stream = file >= 0 ? fdopen(file, "wb") : NULL;
    if (!stream)
        return diag_system(d, path, "cannot write");
    const bool written = fputs(r->start, stream) >= 0;
    const bool closed = fclose(stream) == 0;
    if (written && closed)
        return true;
    diag_system(d, path, "cannot write");
    unlink(path);
    return false;
}

void resume_free(struct resume *r)
{
    checkpoint_free(&r->file);
    free(r->start);
    *r = (struct resume){0};
}
