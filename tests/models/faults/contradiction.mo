model M
  Real x;
  Real y;
  Real z;
equation
  x = 1;
  y = x;
  y = 2;
end M;
