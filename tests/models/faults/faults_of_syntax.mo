model M
  Real x = (1 + 2;
  Real y = 3
  Real z = 4;
equation
  z = + ;
end M;
