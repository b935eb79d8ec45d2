/* A failure of the network cannot be agreed on: it ends the job. */
#ifndef FOOTPOINT_MPI_CHECK_H
#define FOOTPOINT_MPI_CHECK_H

#define CHECK(call) mpi_check((call), #call)
void mpi_check(int code, const char *call);

#endif
