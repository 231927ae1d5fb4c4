model M
  Real x(start = 0, fixed = true);
  Real y(start = 5, fixed = true);
equation
  der(x) = 1;
  y = x;
end M;
