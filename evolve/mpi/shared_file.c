/* Files written by all ranks; see shared_file.h. */
#include "shared_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Selects ROMIO, which comes with Open MPI and every other MPI. Open MPI's own I/O does not report a full disk, and
 * fails to open files if its shared file pointers, unused here, lack a resource. */
void shared_file_prepare(void)
{
    setenv("OMPI_MCA_io", "^ompio", 0);
}

/* Checks a code of MPI. errno, which MPI leaves set, gives the reason. */
static bool written(const struct shared_file *f, int code, struct diag *d)
{
    char text[MPI_MAX_ERROR_STRING] = "";
    int length;
    if (code == MPI_SUCCESS)
        return true;
    if (errno != 0)
        return diag_system(d, f->path, "cannot write");
    MPI_Error_string(code, text, &length);
    diag_at(d, f->path, 0, 0, "cannot write: %s", text);
    d->code = EXIT_SYSTEM;
    return false;
}

bool shared_file_open(struct shared_file *f, const struct team *t, const char *path, struct diag *d)
{
    errno = 0;
    const int code = MPI_File_open(t->comm, path, MPI_MODE_WRONLY, MPI_INFO_NULL, &f->file);
    return team_agree(t, written(f, code, d), d);
}

bool shared_file_write(struct shared_file *f, size_t place, const void *data, size_t bytes, struct diag *d)
{
    enum { MOST = 1 << 30 };
    const char *from = data;
    for (size_t done = 0; done < bytes;) {
        const size_t part = bytes - done < MOST ? bytes - done : MOST;
        MPI_Status status;
        int count = 0;
        errno = 0;
        const int code =
            MPI_File_write_at(f->file, (MPI_Offset)(place + done), from + done, (int)part, MPI_BYTE, &status);
        if (!written(f, code, d))
            return false;
        MPI_Get_count(&status, MPI_BYTE, &count);
        if (count <= 0)
            return written(f, MPI_ERR_IO, d);
        done += (size_t)count;
    }
    return true;
}

bool shared_file_close(struct shared_file *f, struct diag *d)
{
    errno = 0;
    const bool synced = written(f, MPI_File_sync(f->file), d);
    return written(f, MPI_File_close(&f->file), d) && synced;
}
