// Two boxes for blocks.inp: a coarse lower one of 14 x 14 x 2 and a finer upper one of 20 x 20 x 2 hexahedra.
Point(1) = {0, 0, 0};
line[] = Extrude {40, 0, 0} { Point{1}; Layers{14}; };
base[] = Extrude {0, 40, 0} { Line{line[1]}; Layers{14}; Recombine; };
lower[] = Extrude {0, 0, 12} { Surface{base[1]}; Layers{2}; Recombine; };

Point(101) = {4, 4, 12};
line2[] = Extrude {32, 0, 0} { Point{101}; Layers{20}; };
base2[] = Extrude {0, 32, 0} { Line{line2[1]}; Layers{20}; Recombine; };
upper[] = Extrude {0, 0, 8} { Surface{base2[1]}; Layers{2}; Recombine; };

Physical Volume("LOWER") = {lower[1]};
Physical Volume("UPPER") = {upper[1]};
