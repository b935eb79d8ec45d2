/* The arguments of each kind of segment in a call of an emitted function. */
#ifndef FOOTPOINT_KIND_ARGUMENTS_H
#define FOOTPOINT_KIND_ARGUMENTS_H

/** Nodes x[0], x[1], ... and the slave node s as arguments. */
#define NODES_OF_quad4(x, s) (x)[0], (x)[1], (x)[2], (x)[3], s
#define NODES_OF_tri3(x, s) (x)[0], (x)[1], (x)[2], s
#define NODES_OF_tri6(x, s) (x)[0], (x)[1], (x)[2], (x)[3], (x)[4], (x)[5], s
#define NODES_OF_quad8(x, s) (x)[0], (x)[1], (x)[2], (x)[3], (x)[4], (x)[5], (x)[6], (x)[7], s
#define NODES_OF_quad9(x, s) (x)[0], (x)[1], (x)[2], (x)[3], (x)[4], (x)[5], (x)[6], (x)[7], (x)[8], s
#define NODES_OF_gregory(x, s) (x)[0], (x)[1], (x)[2], (x)[3], (x)[4], (x)[5], (x)[6], (x)[7], s
#define NODES_OF_bezier NODES_OF_gregory

/** Their number, with the slave node. */
enum {
    VECTORS_OF_quad4 = 5,
    VECTORS_OF_tri3 = 4,
    VECTORS_OF_tri6 = 7,
    VECTORS_OF_quad8 = 9,
    VECTORS_OF_quad9 = 10,
    VECTORS_OF_gregory = 9,
    VECTORS_OF_bezier = 9
};

#endif
