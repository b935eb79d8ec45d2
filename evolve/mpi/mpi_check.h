/* Ends the job on a network failure, because ranks cannot agree on anything then. */
#ifndef FOOTPOINT_MPI_CHECK_H
#define FOOTPOINT_MPI_CHECK_H

#define CHECK(call) mpi_check((call), #call)
void mpi_check(int code, const char *call);

#endif
