// Plan view of punch.inp: a sheet of 120 x 80 mm and a round punch above it, both of quadrilaterals alone.
Point(1) = {0, 0, 0};
Point(2) = {120, 0, 0};
Point(3) = {120, 80, 0};
Point(4) = {0, 80, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Point(5) = {63, 38, 100};
Point(6) = {99, 38, 100};
Point(7) = {63, 74, 100};
Point(8) = {27, 38, 100};
Point(9) = {63, 2, 100};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(2) = {2};

Physical Surface("SHEET") = {1};
Physical Surface("PUNCH") = {2};

// Each quadrilateral is cut in four at the end: twice the wanted edge.  It varies from 2.5 to 4.5 mm on the sheet (z = 0)
// and is 2.6 mm on the punch (z = 100).
Field[1] = MathEval;
Field[1].F = "(7 + 2*sin(x/17)*cos(y/13))*(1 - z/100) + 5.2*z/100";
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;
