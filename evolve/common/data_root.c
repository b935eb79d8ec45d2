/* Finds frames, scenes and start genomes; see data_root.h. The installed place is relative to the program, so that an
 * installation can be staged and moved. */
#include "data_root.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PATH = 700 }; /* longest root that leaves room for paths below it */

static bool holds_frames(const char *root)
{
    char path[PATH + 32];
    snprintf(path, sizeof path, "%s/evolve/frames", root);
    return access(path, R_OK) == 0;
}

const char *root_default(void)
{
    static char installed[PATH];
    char program[PATH];
    if (holds_frames("."))
        return ".";
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (length <= 0 || length >= (ssize_t)sizeof program - 32)
        return ".";
    program[length] = '\0';
    for (int up = 0; up < 2; up++) {
        char *const slash = strrchr(program, '/');
        if (!slash)
            return ".";
        *slash = '\0';
    }
    snprintf(installed, sizeof installed, "%.660s/share/footpoint", program);
    return holds_frames(installed) ? installed : ".";
}

bool root_is_installed(const char *root)
{
    const char *const usual = root_default();
    return strcmp(usual, ".") != 0 && strcmp(usual, root) == 0;
}
