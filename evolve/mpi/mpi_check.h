/* A failure of the network cannot be agreed on: it ends the job. */
#ifndef FOOTPOINT_MPI_CHECK_H
#define FOOTPOINT_MPI_CHECK_H

#define CHECK(call) migrate_check((call), #call)
void migrate_check(int code, const char *call);

#endif
