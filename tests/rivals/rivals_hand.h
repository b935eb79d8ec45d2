/* Functions of the scene quad4 that were derived by hand: Gauss-Newton and Newton steps, the first with taper and warp,
 * as the frame `parallelogram` defines them (u3, its `chebyshev` of uz, u4, u5, u6) and codegen schedules them. The
 * bred functions that replaced them must not be slower or less accurate. */
#ifndef FOOTPOINT_RIVALS_HAND_H
#define FOOTPOINT_RIVALS_HAND_H

#include "rivals.h"

/** R(name). */
#define RIVAL_HAND(R)                                                                                                  \
    R(hand_balanced)                                                                                                   \
    R(hand_fine)                                                                                                       \
    R(hand_precise)                                                                                                    \
    R(hand_accurate)                                                                                                   \
    R(hand_full)

RIVAL_FN void rival_hand_balanced(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL t1 = xA[0] - xB[0], t2 = xA[1] - xB[1], t3 = xA[2] - xB[2], t4 = 0.5 * (xD[1] - xC[1] - t2);
    const FOOTPOINT_REAL t5 = xA[1] - xD[1] + t4, t6 = 0.5 * (xD[0] - xC[0] - t1), t7 = xA[0] - xD[0] + t6;
    const FOOTPOINT_REAL t8 = 0.5 * (xD[2] - xC[2] - t3), t9 = t2 - 2.0 * (xA[1] - xS[1]) + t5, t10 = t2 + t4;
    const FOOTPOINT_REAL t11 = t7 - (2.0 * (xA[0] - xS[0]) - t1), t12 = t1 + t6, t13 = xD[2] - xA[2] - t8;
    const FOOTPOINT_REAL t14 = t3 - 2.0 * (xA[2] - xS[2]) - t13, t15 = t3 + t8, t16 = t5 * t10 + t7 * t12 - t13 * t15;
    const FOOTPOINT_REAL t17 = t4 * t5 + t6 * t7 - t8 * t13, t18 = t5 * t5 + t7 * t7 + t13 * t13;
    const FOOTPOINT_REAL t19 = t5 * t9 + t7 * t11 - t13 * t14, t20 = t15 * t14 + t10 * t9 + t12 * t11;
    const FOOTPOINT_REAL t21 = t8 * t15 + t4 * t10 + t6 * t12, t22 = t15 * t15 + t10 * t10 + t12 * t12;
    const FOOTPOINT_REAL t23 = t17 * t22 - t16 * t21, t24 = t18 * t20 - t16 * t19, t25 = t18 * t22 - t16 * t16;
    const FOOTPOINT_REAL t26 = t18 * t21 - t17 * t16, t27 = t22 * t19 - t16 * t20, t28 = t23 * t24, t29 = t26 * t27;
    const FOOTPOINT_REAL t30 = t28 - t25 * t25 + t29, t31 = t28 * t29 - t30 * t30, t32 = t25 * t31, t33 = 1.0 / t32;
    const FOOTPOINT_REAL t34 = t25 * t24 * t27 * t30 * t33, t35 = t31 * t33, t36 = t35 * (t24 + t26 * t34);
    const FOOTPOINT_REAL t37 = t35 * (t27 + t23 * t34), t38 = t8 * t8 + t4 * t4 + t6 * t6, t39 = t17 - t38 * t36;
    const FOOTPOINT_REAL t40 = t21 - t38 * t37, t41 = t37 * t39, t42 = t36 * (t17 + t39) - t18, t43 = t21 * t36 + t41;
    const FOOTPOINT_REAL t44 = t16 + (t8 * t14 + t4 * t9 + t6 * t11) - 2.0 * t43, t45 = t37 * (t21 + t40) - t22;
    const FOOTPOINT_REAL t46 = t19 - t36 * (t41 + t43), t47 = t20 - t37 * (t36 * t40 + t43);
    const FOOTPOINT_REAL t48 = 1.0 / (t42 * t45 - t44 * t44);
    *xi = (t44 * t46 + t42 * t47) * t48;
    *eta = (t45 * t46 + t44 * t47) * t48;
}

RIVAL_FN void rival_hand_fine(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL t1 = xA[2] - xB[2], t2 = xA[1] - xB[1], t3 = 0.5 * (xD[2] - xC[2] - t1),
                         t4 = xA[2] - xD[2] + t3;
    const FOOTPOINT_REAL t5 = t1 + t3, t6 = t4 + (t1 - 2.0 * (xA[2] - xS[2])), t7 = 0.5 * (xD[1] - xC[1] - t2);
    const FOOTPOINT_REAL t8 = xA[1] - xD[1] + t7, t9 = t2 + t7, t10 = t8 + (t2 - 2.0 * (xA[1] - xS[1])),
                         t11 = xA[0] - xB[0];
    const FOOTPOINT_REAL t12 = 0.5 * (xD[0] - xC[0] - t11), t13 = xA[0] - xD[0] + t12, t14 = t11 + t12;
    const FOOTPOINT_REAL t15 = t13 + (t11 - 2.0 * (xA[0] - xS[0])), t16 = t4 * t5 + t8 * t9 + t13 * t14;
    const FOOTPOINT_REAL t17 = t5 * t5 + t9 * t9 + t14 * t14, t18 = t3 * t4 + (t7 * t8 + t12 * t13);
    const FOOTPOINT_REAL t19 = t4 * t4 + t8 * t8 + t13 * t13, t20 = t4 * t6 + t8 * t10 + t13 * t15;
    const FOOTPOINT_REAL t21 = t3 * t5 + t7 * t9 + t12 * t14, t22 = t5 * t6 + t9 * t10 + t14 * t15;
    const FOOTPOINT_REAL t23 = t19 * t17 - t16 * t16, t24 = t16 * t21 - t18 * t17, t25 = t19 * t22 - t16 * t20;
    const FOOTPOINT_REAL t26 = t19 * t21 - t18 * t16, t27 = t17 * t20 - t16 * t22, t28 = t24 * t25, t29 = t26 * t27;
    const FOOTPOINT_REAL t30 = t29 - t23 * t23 - t28, t31 = t28 * t29 + t30 * t30, t32 = t23 * t31, t33 = 1.0 / t32;
    const FOOTPOINT_REAL t34 = t23 * t25 * t27 * t30 * t33, t35 = t31 * t33, t36 = t35 * (t25 - t26 * t34);
    const FOOTPOINT_REAL t37 = t35 * (t27 + t24 * t34), t38 = t3 * t3 + t7 * t7 + t12 * t12, t39 = t18 - t38 * t36;
    const FOOTPOINT_REAL t40 = t21 - t38 * t37, t41 = t36 * (t18 + t39) - t19, t42 = t37 * (t21 + t40) - t17,
                         t43 = t37 * t39;
    const FOOTPOINT_REAL t44 = t21 * t36 + t43, t45 = t16 + (t3 * t6 + t7 * t10 + t12 * t15) - 2.0 * t44;
    const FOOTPOINT_REAL t46 = t20 - t36 * (t43 + t44), t47 = t22 - t37 * (t36 * t40 + t44);
    const FOOTPOINT_REAL t48 = 1.0 / (t41 * t42 - t45 * t45), t49 = t42 * t46 + t45 * t47;
    const FOOTPOINT_REAL t50 = (t45 * t46 + t41 * t47) * t48, t51 = t36 + t50, t52 = t40 * t51,
                         t53 = 2.0 * (t37 + t49 * t48);
    const FOOTPOINT_REAL t54 = t39 * t53, t55 = t51 * (t52 + t54), t56 = t53 * (t52 + 0.25 * t54);
    *xi = t50 + t48 * (t41 * t56 + t45 * t55);
    *eta = t48 * (t49 + (t45 * t56 + t42 * t55));
}

RIVAL_FN void rival_hand_precise(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL t1 = xA[2] - xB[2], t2 = xA[1] - xB[1], t3 = xA[0] - xB[0], t4 = 0.5 * (xD[2] - xC[2] - t1);
    const FOOTPOINT_REAL t5 = 0.5 * (xD[1] - xC[1] - t2), t6 = 0.5 * (xD[0] - xC[0] - t3), t7 = xA[2] - xD[2] + t4;
    const FOOTPOINT_REAL t8 = t1 - 2.0 * (xA[2] - xS[2]) + t7, t9 = t1 + t4, t10 = xA[1] - xD[1] + t5;
    const FOOTPOINT_REAL t11 = t2 - 2.0 * (xA[1] - xS[1]) + t10, t12 = t2 + t5, t13 = xA[0] - xD[0] + t6;
    const FOOTPOINT_REAL t14 = t3 - 2.0 * (xA[0] - xS[0]) + t13, t15 = t3 + t6, t16 = t7 * t9 + t10 * t12 + t13 * t15;
    const FOOTPOINT_REAL t17 = t9 * t9 + t12 * t12 + t15 * t15, t18 = t4 * t7 + (t5 * t10 + t6 * t13);
    const FOOTPOINT_REAL t19 = t7 * t7 + t10 * t10 + t13 * t13, t20 = t7 * t8 + t10 * t11 + t13 * t14;
    const FOOTPOINT_REAL t21 = t9 * t8 + (t12 * t11 + t15 * t14), t22 = t4 * t9 + t5 * t12 + t6 * t15;
    const FOOTPOINT_REAL t23 = t19 * t17 - t16 * t16, t24 = t22 * t16 - t18 * t17, t25 = t19 * t21 - t16 * t20;
    const FOOTPOINT_REAL t26 = t22 * t19 - t18 * t16, t27 = t17 * t20 - t16 * t21, t28 = t24 * t25, t29 = t26 * t27;
    const FOOTPOINT_REAL t30 = t29 - t28 - t23 * t23, t31 = t28 * t29 + t30 * t30, t32 = t23 * t31, t33 = 1.0 / t32;
    const FOOTPOINT_REAL t34 = t23 * t25 * t27 * t30 * t33, t35 = t31 * t33, t36 = t35 * (t25 - t26 * t34);
    const FOOTPOINT_REAL t37 = t35 * (t27 + t24 * t34), t38 = t4 * t4 + t5 * t5 + t6 * t6, t39 = t18 - t38 * t36;
    const FOOTPOINT_REAL t40 = t16 + (t4 * t8 + t5 * t11 + t6 * t14), t41 = t22 - t38 * t37, t42 = t37 * t39;
    const FOOTPOINT_REAL t43 = t19 - t36 * (t18 + t39), t44 = t17 - t37 * (t22 + t41), t45 = t22 * t36 + t42;
    const FOOTPOINT_REAL t46 = t40 - 2.0 * t45, t47 = t20 - t36 * (t42 + t45), t48 = t21 - t37 * (t36 * t41 + t45);
    const FOOTPOINT_REAL t49 = 1.0 / (t43 * t44 - t46 * t46), t50 = (t43 * t48 - t46 * t47) * t49;
    const FOOTPOINT_REAL t51 = (t46 * t48 - t44 * t47) * t49, t52 = t18 - t38 * t50, t53 = t22 + t38 * t51,
                         t54 = t51 * t52;
    const FOOTPOINT_REAL t55 = t19 - t50 * (t18 + t52), t56 = t17 + t51 * (t22 + t53), t57 = t22 * t50 - t54;
    const FOOTPOINT_REAL t58 = t40 - 2.0 * t57, t59 = t20 + t50 * (t54 - t57), t60 = t21 + t51 * (t50 * t53 + t57);
    const FOOTPOINT_REAL t61 = 1.0 / (t58 * t58 - t56 * t55);
    *xi = (t55 * t60 - t58 * t59) * t61;
    *eta = (t56 * t59 - t58 * t60) * t61;
}

RIVAL_FN void rival_hand_accurate(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL t1 = xA[2] - xB[2], t2 = xA[1] - xB[1], t3 = 0.5 * (xD[2] - xC[2] - t1);
    const FOOTPOINT_REAL t4 = 0.5 * (xD[1] - xC[1] - t2), t5 = xA[0] - xB[0], t6 = 0.5 * (xD[0] - xC[0] - t5);
    const FOOTPOINT_REAL t7 = xA[2] - xD[2] + t3, t8 = t1 - 2.0 * (xA[2] - xS[2]) + t7, t9 = t1 + t3;
    const FOOTPOINT_REAL t10 = xA[1] - xD[1] + t4, t11 = t2 - 2.0 * (xA[1] - xS[1]) + t10, t12 = t2 + t4;
    const FOOTPOINT_REAL t13 = xA[0] - xD[0] + t6, t14 = t5 - 2.0 * (xA[0] - xS[0]) + t13, t15 = t5 + t6;
    const FOOTPOINT_REAL t16 = t7 * t7 + t10 * t10 + t13 * t13, t17 = t7 * t9 + t10 * t12 + t13 * t15;
    const FOOTPOINT_REAL t18 = t9 * t9 + t12 * t12 + t15 * t15, t19 = t7 * t8 + t10 * t11 + t13 * t14;
    const FOOTPOINT_REAL t20 = t3 * t7 + (t4 * t10 + t6 * t13), t21 = t3 * t9 + t4 * t12 + t6 * t15;
    const FOOTPOINT_REAL t22 = t9 * t8 + t12 * t11 + t15 * t14, t23 = t16 * t18 - t17 * t17,
                         t24 = t21 * t17 - t20 * t18;
    const FOOTPOINT_REAL t25 = t16 * t22 - t17 * t19, t26 = t21 * t16 - t20 * t17, t27 = t18 * t19 - t17 * t22;
    const FOOTPOINT_REAL t28 = t24 * t25, t29 = t26 * t27, t30 = t29 - t28 - t23 * t23, t31 = t28 * t29 + t30 * t30;
    const FOOTPOINT_REAL t32 = t23 * t31, t33 = 1.0 / t32, t34 = t23 * t25 * t27 * t30 * t33, t35 = t31 * t33;
    const FOOTPOINT_REAL t36 = t25 - t26 * t34, t37 = t27 + t24 * t34, t38 = t3 * t3 + t4 * t4 + t6 * t6,
                         t39 = t35 * t36;
    const FOOTPOINT_REAL t40 = t35 * t37, t41 = t20 - t38 * t39, t42 = t37 * t41,
                         t43 = t17 + (t3 * t8 + t4 * t11 + t6 * t14);
    const FOOTPOINT_REAL t44 = t21 - t38 * t40, t45 = t16 - t39 * (t20 + t41), t46 = t21 * t36 + t42;
    const FOOTPOINT_REAL t47 = t18 - t40 * (t21 + t44), t48 = t43 - 2.0 * t35 * t46,
                         t49 = t19 - t35 * t39 * (t42 + t46);
    const FOOTPOINT_REAL t50 = t22 - t35 * t40 * (t36 * t44 + t46), t51 = 1.0 / (t45 * t47 - t48 * t48);
    const FOOTPOINT_REAL t52 = (t45 * t50 - t48 * t49) * t51, t53 = (t47 * t49 - t48 * t50) * t51,
                         t54 = t20 - t38 * t52;
    const FOOTPOINT_REAL t55 = t21 - t38 * t53, t56 = t53 * t54, t57 = t16 - t52 * (t20 + t54),
                         t58 = t18 - t53 * (t21 + t55);
    const FOOTPOINT_REAL t59 = t21 * t52 + t56, t60 = t43 - 2.0 * t59, t61 = t19 - t52 * (t56 + t59);
    const FOOTPOINT_REAL t62 = t22 - t53 * (t52 * t55 + t59), t63 = 1.0 / (t57 * t58 - t60 * t60);
    const FOOTPOINT_REAL t64 = (t57 * t62 - t60 * t61) * t63, t65 = (t58 * t61 - t60 * t62) * t63,
                         t66 = t20 - t38 * t64;
    const FOOTPOINT_REAL t67 = t21 - t38 * t65, t68 = t16 - t64 * (t20 + t66), t69 = t65 * t66,
                         t70 = t18 - t65 * (t21 + t67);
    const FOOTPOINT_REAL t71 = t21 * t64 + t69, t72 = 2.0 * t71 - t43, t73 = t22 - t65 * (t64 * t67 + t71);
    const FOOTPOINT_REAL t74 = t19 - t64 * (t69 + t71), t75 = 1.0 / (t72 * t72 - t68 * t70);
    *xi = (t68 * t73 + t72 * t74) * t75;
    *eta = (t72 * t73 + t70 * t74) * t75;
}

RIVAL_FN void rival_hand_full(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL t1 = xA[2] - xB[2], t2 = xA[1] - xB[1], t3 = 0.5 * (xD[2] - xC[2] - t1);
    const FOOTPOINT_REAL t4 = 0.5 * (xD[1] - xC[1] - t2), t5 = xA[0] - xB[0], t6 = t2 + t4,
                         t7 = 0.5 * (xD[0] - xC[0] - t5);
    const FOOTPOINT_REAL t8 = xA[2] - xD[2] + t3, t9 = t1 - 2.0 * (xA[2] - xS[2]) + t8, t10 = t1 + t3;
    const FOOTPOINT_REAL t11 = xA[1] - xD[1] + t4, t12 = t2 - 2.0 * (xA[1] - xS[1]) + t11, t13 = xA[0] - xD[0] + t7;
    const FOOTPOINT_REAL t14 = t5 - 2.0 * (xA[0] - xS[0]) + t13, t15 = t5 + t7, t16 = t8 * t10 + t11 * t6 + t13 * t15;
    const FOOTPOINT_REAL t17 = t10 * t10 + t6 * t6 + t15 * t15, t18 = t8 * t8 + t11 * t11 + t13 * t13;
    const FOOTPOINT_REAL t19 = t11 * t12 + t8 * t9 + t13 * t14, t20 = t3 * t8 + (t4 * t11 + t7 * t13);
    const FOOTPOINT_REAL t21 = t3 * t10 + t4 * t6 + t7 * t15, t22 = t6 * t12 + t10 * t9 + t15 * t14;
    const FOOTPOINT_REAL t23 = t18 * t17 - t16 * t16, t24 = t21 * t16 - t20 * t17, t25 = t18 * t22 - t16 * t19;
    const FOOTPOINT_REAL t26 = t21 * t18 - t20 * t16, t27 = t17 * t19 - t16 * t22,
                         t28 = t26 * t27 - t23 * t23 - t24 * t25;
    const FOOTPOINT_REAL t29 = t27 * t25, t30 = t24 * t26 * t29 + t28 * t28, t31 = t23 * t30, t32 = 1.0 / t31;
    const FOOTPOINT_REAL t33 = t23 * t29 * t28 * t32, t34 = t30 * t32, t35 = t34 * (t25 - t26 * t33);
    const FOOTPOINT_REAL t36 = t34 * (t27 + t24 * t33), t37 = t3 * t3 + t4 * t4 + t7 * t7, t38 = t20 - t37 * t35;
    const FOOTPOINT_REAL t39 = t16 + (t4 * t12 + t3 * t9 + t7 * t14), t40 = t21 - t37 * t36, t41 = t36 * t38;
    const FOOTPOINT_REAL t42 = t18 - t35 * (t20 + t38), t43 = t17 - t36 * (t21 + t40), t44 = t21 * t35 + t41;
    const FOOTPOINT_REAL t45 = t39 - 2.0 * t44, t46 = t19 - t35 * (t41 + t44), t47 = t22 - t36 * (t35 * t40 + t44);
    const FOOTPOINT_REAL t48 = 1.0 / (t42 * t43 - t45 * t45), t49 = (t42 * t47 - t45 * t46) * t48;
    const FOOTPOINT_REAL t50 = (t43 * t46 - t45 * t47) * t48, t51 = t20 - t37 * t49, t52 = t21 - t37 * t50,
                         t53 = t50 * t51;
    const FOOTPOINT_REAL t54 = t18 - t49 * (t20 + t51), t55 = t17 - t50 * (t21 + t52), t56 = t21 * t49 + t53;
    const FOOTPOINT_REAL t57 = t39 - 2.0 * t56, t58 = t19 - t49 * (t53 + t56), t59 = t22 - t50 * (t49 * t52 + t56);
    const FOOTPOINT_REAL t60 = 1.0 / (t54 * t55 - t57 * t57), t61 = (t54 * t59 - t57 * t58) * t60;
    const FOOTPOINT_REAL t62 = (t55 * t58 - t57 * t59) * t60, t63 = t20 - t37 * t61, t64 = t21 - t37 * t62,
                         t65 = t62 * t63;
    const FOOTPOINT_REAL t66 = t18 - t61 * (t20 + t63), t67 = t17 - t62 * (t21 + t64), t68 = t21 * t61 + t65;
    const FOOTPOINT_REAL t69 = t39 - 2.0 * t68, t70 = t19 - t61 * (t65 + t68), t71 = t22 - t62 * (t61 * t64 + t68);
    const FOOTPOINT_REAL t72 = 1.0 / (t66 * t67 - t69 * t69), t73 = (t66 * t71 - t69 * t70) * t72;
    const FOOTPOINT_REAL t74 = (t67 * t70 - t69 * t71) * t72, t75 = t20 - t37 * t73, t76 = t21 - t37 * t74,
                         t77 = t74 * t75;
    const FOOTPOINT_REAL t78 = t18 - t73 * (t20 + t75), t79 = t17 - t74 * (t21 + t76), t80 = t21 * t73 + t77;
    const FOOTPOINT_REAL t81 = 2.0 * t80 - t39, t82 = t19 - t73 * (t77 + t80), t83 = t22 - t74 * (t73 * t76 + t80);
    const FOOTPOINT_REAL t84 = 1.0 / (t81 * t81 - t79 * t78);
    *xi = (t81 * t82 + t78 * t83) * t84;
    *eta = (t79 * t82 + t81 * t83) * t84;
}

#endif
