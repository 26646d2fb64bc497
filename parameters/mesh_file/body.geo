// A capsule: a tube with round ends, filled with liquid. A quarter of it
// (y >= 0, z >= 0), of hexahedra only. Make body.msh with
//
//   gmsh -3 body.geo
//
// The x axis is the axis of the body, as the program wants it.

radius    = 2;   // of the chamber, and of its round ends [mm]
length    = 10;  // of the chamber, from end to end
thickness = 0.3; // of the wall
core      = 0.9; // half the edge of the bar of liquid along the axis

n_angle    = 2; // cells in an eighth of the circle
n_straight = 4; // along the straight part
n_bend     = 2; // along each bend
n_liquid   = 1; // from the bar to the wall
n_wall     = 1; // through the wall

// The cross-section has ten points: the bar 0, 1, 2, 3 around the axis 0, the
// inner (4, 5, 6) and the outer surface (7, 8, 9) of the wall.
//
//   9--8
//   6--5 \
//   |   \ \
//   3--2 \ \
//   |  |  | |
//   0--1--4-7
//
// There are four of these, at the head, at both ends of the straight part, and
// at the tail. The points of station s are 10*s + 0 ... 9.
x_core() = {0.45*radius, radius, length - radius, length - 0.45*radius};
Point(91) = {radius, 0, 0};          // the centres of the round ends
Point(92) = {length - radius, 0, 0};

For s In {0:3}
  diagonal = 0.8*core;
  Point(10*s)     = {x_core(s), 0, 0};
  Point(10*s + 1) = {x_core(s), core, 0};
  Point(10*s + 2) = {x_core(s), diagonal, diagonal};
  Point(10*s + 3) = {x_core(s), 0, core};

  // At head and tail the end of the wall is half way around the bend.
  is_end = (s == 0 || s == 3);
  side   = (s < 2 ? -1 : 1)*is_end;
  x      = (s < 2 ? radius : length - radius);
  For layer In {0:1}
    r = radius + layer*thickness;
    k = 10*s + 4 + 3*layer;
    a = r/Sqrt(1 + is_end);
    b = r/Sqrt(2 + is_end);
    Point(k)     = {x + side*a, a, 0};
    Point(k + 1) = {x + side*b, b, b};
    Point(k + 2) = {x + side*a, 0, a};
  EndFor
EndFor

// Curves: 100*s + ... in the cross-sections, 1000 + 10*s + k along x.
// from[] and to[] are the points of the curves of a cross-section.
from() = {0, 1, 2, 3, 1, 2, 3, 4, 5, 4, 5, 6, 7, 8};
to()   = {1, 2, 3, 0, 4, 5, 6, 5, 6, 7, 8, 9, 8, 9};
For s In {0:3}
  centre = (s < 2 ? 91 : 92);
  For i In {0:13}
    p = 10*s + from(i);
    q = 10*s + to(i);
    If (i == 7 || i == 8 || i == 12 || i == 13)
      Circle(100*(s + 1) + i) = {p, centre, q};
    Else
      Line(100*(s + 1) + i) = {p, q};
    EndIf
    If (i < 4 || i == 7 || i == 8 || i == 12 || i == 13)
      Transfinite Curve{100*(s + 1) + i} = n_angle + 1;
    ElseIf (i < 7)
      Transfinite Curve{100*(s + 1) + i} = n_liquid + 1;
    Else
      Transfinite Curve{100*(s + 1) + i} = n_wall + 1;
    EndIf
  EndFor
EndFor
For s In {0:2}
  For k In {0:9}
    If (s == 1 || k < 4)
      Line(1000 + 10*s + k) = {10*s + k, 10*s + 10 + k};
    Else
      Circle(1000 + 10*s + k) = {10*s + k, (s == 0 ? 91 : 92), 10*s + 10 + k};
    EndIf
    Transfinite Curve{1000 + 10*s + k} = (s == 1 ? n_straight : n_bend) + 1;
  EndFor
EndFor

// Surfaces: 10*(s + 1) + ... in the cross-sections, 100*(s + 1) + i between
// two of them, along curve i.
For s In {0:3}
  c = 100*(s + 1);
  Curve Loop(10*(s + 1)) = {c, c + 1, c + 2, c + 3};
  Surface(10*(s + 1)) = {10*(s + 1)};
  Curve Loop(10*(s + 1) + 1) = {c + 4, c + 7, -(c + 5), -(c + 1)};
  Surface(10*(s + 1) + 1) = {10*(s + 1) + 1};
  Curve Loop(10*(s + 1) + 2) = {c + 5, c + 8, -(c + 6), -(c + 2)};
  Surface(10*(s + 1) + 2) = {10*(s + 1) + 2};
  Curve Loop(10*(s + 1) + 3) = {c + 9, c + 12, -(c + 10), -(c + 7)};
  Surface(10*(s + 1) + 3) = {10*(s + 1) + 3};
  Curve Loop(10*(s + 1) + 4) = {c + 10, c + 13, -(c + 11), -(c + 8)};
  Surface(10*(s + 1) + 4) = {10*(s + 1) + 4};
EndFor
For s In {0:2}
  For i In {0:13}
    c = 100*(s + 1) + i;
    Curve Loop(c) = {c, 1000 + 10*s + to(i), -(c + 100), -(1000 + 10*s + from(i))};
    If (s != 1 && (i == 7 || i == 8 || i == 12 || i == 13))
      Surface(c) = {c} In Sphere {s == 0 ? 91 : 92};
    Else
      Surface(c) = {c};
    EndIf
  EndFor
EndFor

// Volumes: 10*(s + 1) + 0 ... 4 over the surfaces of the cross-section.
For s In {0:2}
  c = 100*(s + 1);
  t = 10*(s + 1);
  Surface Loop(t) = {t, t + 10, c, c + 1, c + 2, c + 3};
  Volume(t) = {t};
  Surface Loop(t + 1) = {t + 1, t + 11, c + 4, c + 7, c + 5, c + 1};
  Volume(t + 1) = {t + 1};
  Surface Loop(t + 2) = {t + 2, t + 12, c + 5, c + 8, c + 6, c + 2};
  Volume(t + 2) = {t + 2};
  Surface Loop(t + 3) = {t + 3, t + 13, c + 9, c + 12, c + 10, c + 7};
  Volume(t + 3) = {t + 3};
  Surface Loop(t + 4) = {t + 4, t + 14, c + 10, c + 13, c + 11, c + 8};
  Volume(t + 4) = {t + 4};
EndFor

// The ends: from the end of the bar to the poles 50 (inside) and 51 (outside)
// at the head, 60 and 61 at the tail.
For e In {0:1}
  s = 3*e;
  n = 50 + 10*e;
  c = 100*(s + 1);
  t = 10*(s + 1);
  m = 2000 + 100*e;
  Point(n)     = {e*length, 0, 0};
  Point(n + 1) = {e*length + (2*e - 1)*thickness, 0, 0};
  Line(m)       = {10*s, n};
  Line(m + 1)   = {n, n + 1};
  Circle(m + 2) = {n, 91 + e, 10*s + 4};
  Circle(m + 3) = {n, 91 + e, 10*s + 6};
  Circle(m + 4) = {n + 1, 91 + e, 10*s + 7};
  Circle(m + 5) = {n + 1, 91 + e, 10*s + 9};
  Transfinite Curve{m} = n_liquid + 1;
  Transfinite Curve{m + 1} = n_wall + 1;
  Transfinite Curve{m + 2 : m + 5} = n_angle + 1;

  Curve Loop(m) = {c, c + 4, -(m + 2), -m};
  Surface(m) = {m};
  Curve Loop(m + 1) = {-(c + 3), c + 6, -(m + 3), -m};
  Surface(m + 1) = {m + 1};
  Curve Loop(m + 2) = {m + 2, c + 7, c + 8, -(m + 3)};
  Surface(m + 2) = {m + 2} In Sphere {91 + e};
  Curve Loop(m + 3) = {m + 2, c + 9, -(m + 4), -(m + 1)};
  Surface(m + 3) = {m + 3};
  Curve Loop(m + 4) = {m + 3, c + 11, -(m + 5), -(m + 1)};
  Surface(m + 4) = {m + 4};
  Curve Loop(m + 5) = {m + 4, c + 12, c + 13, -(m + 5)};
  Surface(m + 5) = {m + 5} In Sphere {91 + e};

  Surface Loop(n) = {t, t + 1, t + 2, m, m + 1, m + 2};
  Volume(n) = {n};
  Surface Loop(n + 1) = {m + 2, m + 5, t + 3, t + 4, m + 3, m + 4};
  Volume(n + 1) = {n + 1};
EndFor

Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};

// What is what. One segment, so the names of the volumes need no number.
Physical Volume("liquid") = {10:12, 20:22, 30:32, 50, 60};
Physical Volume("wall") = {13, 14, 23, 24, 33, 34};
Physical Volume("cap") = {51, 61};

// The chamber is the surface between liquid and wall, without the ends: round
// surfaces must not meet the axis.
Physical Surface("skin") = {112, 113, 212, 213, 312, 313};
Physical Surface("chamber") = {107, 108, 207, 208, 307, 308};
Physical Surface("head") = {2005};
Physical Surface("tail") = {2105};
Physical Surface("symmetry y") = {103, 106, 111, 203, 206, 211, 303, 306, 311,
                                  2001, 2004, 2101, 2104};
Physical Surface("symmetry z") = {100, 104, 109, 200, 204, 209, 300, 304, 309,
                                  2000, 2003, 2100, 2103};

Mesh.MshFileVersion = 4.1;
