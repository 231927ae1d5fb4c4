model M
  Real x;
  Real y;
  Real z;
equation
  x = y;
  y = z;
  z = x;
end M;
