model M
  Real x;
  Real y;
  Real z;
equation
  sin(x) = 0.5;
  cos(x) = 0.2;
  x*x = y*z;
end M;
