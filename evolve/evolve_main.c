/* footpoint-evolve: breeds expressions for the foot point on islands over MPI (the paper's pd-LinearGP). A scene
 * defines samples and tiers, frames define the values that expressions use, and the start file contains the champions
 * to beat. Each output of each tier has a ring of islands. */
#include "../codegen/base/console.h"
#include "common/stop.h"
#include "eval/tree_benchmark.h"
#include "input/scene_print.h"
#include "mpi/shared_file.h"
#include "run/run.h"
#include "write/archive_write.h"

#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

/* Evolves from the start, or from the checkpoint to be resumed, whose options apply unless others are given.
 * Collective. */
static bool evolve(int argc, char **argv, const struct evolve_options *given, const struct team *team, int *status,
                   struct diag *d)
{
    const double begun = seconds_now();
    struct evolve_options o = *given;
    if (!o.resume)
        return run_evolution(&o, team, NULL, begun, status, d);
    struct resume resume;
    char *facts = NULL;
    bool good = resume_read(&resume, team, o.resume, d);
    if (good) {
        facts = new_text(resume.file.facts, strlen(resume.file.facts));
        good = team_agree(team, evolve_options_resume(argc, argv, facts, &o, d), d) &&
               run_evolution(&o, team, &resume, begun, status, d);
    }
    resume_free(&resume);
    free(facts);
    return good;
}

/* Keeps freed memory. Tables of samples are allocated and freed often; fresh pages would cost more than the
 * computation. */
static void keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

int main(int argc, char **argv)
{
    keep_memory();
    struct evolve_options o;
    struct diag d = {.code = EXIT_DONE};
    int status = EXIT_DONE;
    shared_file_prepare();
    if (MPI_Init(&argc, &argv) != MPI_SUCCESS)
        return EXIT_SYSTEM;
    stop_listen();
    struct team team = team_new(MPI_COMM_WORLD);
    const enum options_outcome outcome = evolve_options_read(argc, argv, &o, &d);
    if (outcome == OPTIONS_READ && !o.benchmark && !o.samples && !o.print_scene)
        evolve(argc, argv, &o, &team, &status, &d);
    else if (team.rank == 0 && outcome == OPTIONS_READ && o.benchmark)
        evolve_benchmark(stdout);
    else if (team.rank == 0 && outcome == OPTIONS_READ && o.print_scene)
        scene_print(o.print_scene, stdout);
    else if (team.rank == 0 && outcome == OPTIONS_READ)
        samples_write(o.root, o.scene, o.seed, o.start, o.samples, &d);
    else if (team.rank == 0 && outcome != OPTIONS_WRONG)
        options_tell(&evolve_option_table, outcome);
    if (team.rank == 0 && d.code == EXIT_DONE)
        stdout_written(&d);
    if (team.rank == 0 && d.code != EXIT_DONE && d.text[0])
        fprintf(stderr, "%s\n", d.text);
    team_free(&team);
    MPI_Finalize();
    return d.code != EXIT_DONE ? (int)d.code : status;
}
