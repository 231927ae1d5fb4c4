model M
  parameter Real k(unit = "N.m/A") = 0.05;
  parameter Real J(unit = "kg.m2") = 1e-4;
  Real w(unit = "rad/s", start = 0, fixed = true);
  Real i(unit = "A");
equation
  i = 2;
  J*der(w) = k;
end M;
