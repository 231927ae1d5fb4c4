model M
  Real x[3];
  parameter Real a[2] = {1, 2};
equation
  x = a;
end M;
