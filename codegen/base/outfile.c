/* Whole-file output; see outfile.h. */
#include "outfile.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINKS = 40 };

/* Returns the open file behind a path such as /dev/fd/3, or -1 for other paths. */
static int descriptor_of(const char *path)
{
    static const char *const folder[] = {"/dev/fd/", "/proc/self/fd/"};
    unsigned long long number;
    for (int i = 0; i < 2; i++) {
        const size_t n = strlen(folder[i]);
        if (strncmp(path, folder[i], n) == 0 && text_whole(path + n, &number) && number < 65536)
            return (int)number;
    }
    return -1;
}

/* Finds the final target of a path. Links are followed, the last one even if its target does not exist yet. Returns
 * false with errno. */
static bool follow(const char *path, char target[OUTFILE_PATH])
{
    char link[OUTFILE_PATH];
    snprintf(target, OUTFILE_PATH, "%s", path);
    for (int links = 0; links < LINKS; links++) {
        const ssize_t n = descriptor_of(target) >= 0 ? -1 : readlink(target, link, sizeof link);
        const char *slash = strrchr(target, '/');
        const size_t kept = n > 0 && link[0] != '/' && slash ? (size_t)(slash - target) + 1 : 0;
        if (n < 0)
            return true;
        if (kept + (size_t)n >= OUTFILE_PATH) {
            errno = ENAMETOOLONG;
            return false;
        }
        memcpy(target + kept, link, (size_t)n);
        target[kept + (size_t)n] = '\0';
    }
    errno = ELOOP;
    return false;
}

/* Opens a new file beside the target, with the permissions of *old, or default permissions. */
static int open_aside(struct outfile *f, const struct stat *old)
{
    if (old && access(f->target, W_OK) != 0)
        return -1;
    snprintf(f->aside, sizeof f->aside, "%s.XXXXXX.tmp", f->target);
    const int file = mkstemps(f->aside, 4);
    if (file < 0)
        return -1;
    const mode_t mask = umask(0);
    umask(mask);
    /* Keeps owner and group if permitted; a different group gets no more rights than others. */
    const bool same_group =
        old && (fchown(file, old->st_uid, old->st_gid) == 0 || fchown(file, (uid_t)-1, old->st_gid) == 0);
    const mode_t mode = old ? old->st_mode & (same_group ? 0777 : 0707) : 0666 & ~mask;
    if (fchmod(file, mode) == 0)
        return file;
    close(file);
    unlink(f->aside);
    return -1;
}

static int open_target(struct outfile *f)
{
    struct stat s;
    const int descriptor = descriptor_of(f->target);
    if (descriptor >= 0) {
        fflush(stdout);
        return dup(descriptor);
    }
    const bool there = stat(f->target, &s) == 0;
    if (there && !S_ISREG(s.st_mode))
        return open(f->target, O_WRONLY | O_NOCTTY);
    return open_aside(f, there ? &s : NULL);
}

bool outfile_open(struct outfile *f, const char *path, struct diag *d)
{
    *f = (struct outfile){0};
    if (strlen(path) >= sizeof f->path)
        return diag_at(d, path, 0, 0, "path is too long");
    snprintf(f->path, sizeof f->path, "%s", path);
    const int file = follow(path, f->target) ? open_target(f) : -1;
    f->stream = file >= 0 ? fdopen(file, "wb") : NULL;
    return f->stream ? true : diag_system(d, path, "cannot write");
}

bool outfile_commit(struct outfile *f, struct diag *d)
{
    const bool direct = !*f->aside;
    const bool written = !ferror(f->stream) && fflush(f->stream) == 0 && (direct || fsync(fileno(f->stream)) == 0);
    const bool closed = fclose(f->stream) == 0;
    if (written && closed && (direct || rename(f->aside, f->target) == 0))
        return true;
    diag_system(d, f->path, "cannot write");
    if (!direct)
        unlink(f->aside);
    return false;
}

void outfile_discard(struct outfile *f)
{
    fclose(f->stream);
    if (*f->aside)
        unlink(f->aside);
}

bool outfile_probe(const char *path, struct diag *d)
{
    struct outfile f;
    struct stat s;
    if (!path)
        return true;
    /* Opening a pipe would wait for its reader, and closing it would end the reader. */
    if (stat(path, &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode))
        return access(path, W_OK) == 0 || diag_system(d, path, "cannot write");
    if (!outfile_open(&f, path, d))
        return false;
    outfile_discard(&f);
    return true;
}

/* For a file that does not exist yet: returns its name and finds its folder. */
static const char *folder_of(const char *target, struct stat *s)
{
    char folder[OUTFILE_PATH];
    const char *slash = strrchr(target, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - target) + 1 : 1, slash ? target : ".");
    return stat(folder, s) == 0 ? slash ? slash + 1 : target : NULL;
}

/* Returns true if two paths name one regular file or, if neither exists, would create the same file. */
static bool same_file(const char *a, const char *b, bool both_written)
{
    char first[OUTFILE_PATH], second[OUTFILE_PATH];
    struct stat s, t;
    if (!follow(a, first) || !follow(b, second) || descriptor_of(first) >= 0 || descriptor_of(second) >= 0)
        return false;
    const bool there = stat(first, &s) == 0;
    if (there != (stat(second, &t) == 0))
        return false;
    bool one = !there || S_ISREG(s.st_mode);
    if (!there && !both_written)
        return false;
    if (!there) {
        const char *name = folder_of(first, &s), *other = folder_of(second, &t);
        one = name && other && strcmp(name, other) == 0;
    }
    return one && s.st_dev == t.st_dev && s.st_ino == t.st_ino;
}

bool files_apart(const char *program, const struct file_use *file, size_t n, struct diag *d)
{
    for (size_t i = 0; i < n; i++)
        for (size_t k = i + 1; k < n; k++) {
            const struct file_use *a = &file[i], *b = &file[k];
            if (!a->path || !b->path || !(a->written || b->written) || (a->group != 0 && a->group == b->group) ||
                !same_file(a->path, b->path, a->written && b->written))
                continue;
            diag_at(d, program, 0, 0, "%s and %s are one file: %.150s", a->what, b->what, a->path);
            d->code = EXIT_USAGE;
            return false;
        }
    return true;
}
