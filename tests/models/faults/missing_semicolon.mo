model M
  Real x(start = 0, fixed = true)
  Real y;
equation
  der(x) = y;
  y = 1;
end M;
