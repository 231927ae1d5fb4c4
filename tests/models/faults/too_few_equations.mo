model M
  Real x(start = 0, fixed = true);
  Real y;
equation
  der(x) = -x;
end M;
