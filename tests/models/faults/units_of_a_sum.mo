model M
  parameter Real R(unit = "Ohm") = 1;
  parameter Real k(unit = "V.s/rad") = 0.05;
  Real i(unit = "A");
  Real w(unit = "rad/s");
equation
  w = 10;
  12 = R*i + w;
end M;
