/* The log of a run; see run_log.h. */
#include "run_log.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void put(struct run_log *l, const char *line, size_t n)
{
    SHA256Update(&l->sum, (const uint8_t *)line, n);
    l->bytes += n;
    fwrite(line, 1, n, l->stream);
}

bool run_log_open(struct run_log *l, const char *path, struct diag *d)
{
    static const char head[] = "generation,island,tier,output,place,best_error,best_genes,median_error,evaluations\n";
    *l = (struct run_log){.stream = fopen(path, "wb"), .path = path};
    SHA256Init(&l->sum);
    if (!l->stream)
        return diag_system(d, path, "cannot write");
    put(l, head, sizeof head - 1);
    return true;
}

bool run_log_continue(struct run_log *l, const char *path, const struct log_mark *mark, struct diag *d)
{
    size_t size;
    char *text = read_text(path, &size, d);
    if (!text)
        return false;
    *l = (struct run_log){.path = path, .bytes = mark->bytes};
    SHA256Init(&l->sum);
    bool good = size >= mark->bytes;
    if (good) {
        SHA256Update(&l->sum, (const uint8_t *)text, mark->bytes);
        good = strcmp(run_log_mark(l).sha256, mark->sha256) == 0;
    }
    free(text);
    if (!good)
        return diag_at(d, path, 0, 0, "log does not belong to the checkpoint's run");
    l->stream = fopen(path, "r+b");
    if (!l->stream || ftruncate(fileno(l->stream), (off_t)mark->bytes) != 0 || fseek(l->stream, 0, SEEK_END) != 0) {
        diag_system(d, path, "cannot write");
        run_log_close(l);
        return false;
    }
    return true;
}

void run_log_add(struct run_log *l, size_t island, const char *tier, const char *output, size_t place,
                 const struct log_row *row)
{
    char line[400];
    const int n =
        snprintf(line, sizeof line, "%" PRIu64 ",%zu,%.64s,%.64s,%zu,%.6e,%" PRIu64 ",%.6e,%" PRIu64 "\n",
                 row->generation, island, tier, output, place, row->best, row->length, row->median, row->evaluations);
    put(l, line, (size_t)n);
}

bool run_log_sync(struct run_log *l, struct diag *d)
{
    if (!l->stream)
        return true;
    /* fsync fails on terminals and pipes. */
    const bool good = fflush(l->stream) == 0 && !ferror(l->stream);
    if (good)
        fsync(fileno(l->stream));
    return good || diag_system(d, l->path, "cannot write");
}

struct log_mark run_log_mark(const struct run_log *l)
{
    struct log_mark m = {.bytes = l->bytes};
    SHA2_CTX sum = l->sum;
    SHA256End(&sum, m.sha256);
    return m;
}

void run_log_close(struct run_log *l)
{
    if (l->stream)
        fclose(l->stream);
    l->stream = NULL;
}
