/* Going on from a checkpoint; see resume.h. */
#include "resume.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* States are the machine's bytes. */
static const char *machine(void)
{
    const int one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first ? "little-endian" : "big-endian";
}

void resume_facts(char text[FACTS], const char *scene_sha256, size_t generation, const struct log_mark *mark)
{
    snprintf(text, FACTS, "version %s\nmachine %s\nscene-sha256 %s\ngeneration %zu\nlog-mark %" PRIu64 " %s\n",
             FOOTPOINT_VERSION, machine(), scene_sha256, generation, mark->bytes, mark->sha256);
}

static bool known(struct resume *r, struct diag *d)
{
    char value[128], rest;
    if (!checkpoint_fact(r->facts, "version", value, sizeof value) || strcmp(value, FOOTPOINT_VERSION) != 0)
        return diag_at(d, r->path, 0, 0, "checkpoint of version %s; this is %s", value, FOOTPOINT_VERSION);
    if (!checkpoint_fact(r->facts, "machine", value, sizeof value) || strcmp(value, machine()) != 0)
        return diag_at(d, r->path, 0, 0, "checkpoint of a %s machine; this is a %s one", value, machine());
    if (!checkpoint_fact(r->facts, "generation", value, sizeof value) ||
        sscanf(value, "%zu%c", &r->generation, &rest) != 1 ||
        !checkpoint_fact(r->facts, "log-mark", value, sizeof value) ||
        sscanf(value, "%" SCNu64 " %64s", &r->mark.bytes, r->mark.sha256) != 2)
        return diag_at(d, r->path, 0, 0, "checkpoint lacks its generation");
    return true;
}

bool resume_read(struct resume *r, const struct team *t, const char *path, struct diag *d)
{
    *r = (struct resume){.path = path};
    bool good = t->rank > 0 || checkpoint_read(&r->file, path, d);
    if (good && t->rank == 0 && r->file.sections < RESUME_ISLANDS)
        good = diag_at(d, path, 0, 0, "checkpoint lacks its start");
    if (!team_agree(t, good, d))
        return false;
    const bool first = t->rank == 0;
    r->facts = team_tell(t, r->file.facts, first ? strlen(r->file.facts) : 0);
    r->start = team_tell(t, first ? (const char *)r->file.section[RESUME_START].data : NULL,
                         first ? r->file.section[RESUME_START].bytes : 0);
    return team_agree(t, known(r, d), d);
}

bool resume_suits(const struct resume *r, const char *scene_sha256, size_t generations, struct diag *d)
{
    char sha256[65] = "";
    checkpoint_fact(r->facts, "scene-sha256", sha256, sizeof sha256);
    if (strcmp(sha256, scene_sha256) != 0)
        return diag_at(d, r->path, 0, 0, "checkpoint of another scene: SHA-256 %.12s..., not %.12s...", sha256,
                       scene_sha256);
    if (generations >= r->generation)
        return true;
    diag_at(d, r->path, 0, 0, "checkpoint of generation %zu, beyond --generations %zu", r->generation, generations);
    d->code = EXIT_USAGE;
    return false;
}

bool resume_islands(const struct resume *r, const struct team *t, const struct islands *s, struct diag *d)
{
    const size_t n = islands_count(s);
    struct mail mail = {0};
    bool good =
        t->rank > 0 || r->file.sections == n + RESUME_ISLANDS || diag_at(d, r->path, 0, 0, "checkpoint lacks islands");
    if (!team_agree(t, good, d))
        return false;
    for (size_t i = 0; i < n; i++) {
        size_t bytes;
        if (t->rank == 0) {
            const struct checkpoint_part *part = &r->file.section[i + RESUME_ISLANDS];
            mail_send(t, &mail, new_text((const char *)part->data, part->bytes), part->bytes, s->owner[i], TAG_STATE);
        }
        if (s->owner[i] != t->rank)
            continue;
        unsigned char *state = team_receive(t, 0, TAG_STATE, &bytes);
        if (good && (bytes != island_state_size(s->island[i]) || !island_load(s->island[i], state)))
            good = diag_at(d, r->path, 0, 0, "island %zu of the checkpoint is malformed", i);
        free(state);
    }
    mail_free(&mail);
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
    free(r->facts);
    free(r->start);
    *r = (struct resume){0};
}
