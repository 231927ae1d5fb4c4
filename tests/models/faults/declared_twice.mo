model M
  parameter Real k = 1;
  Real x;
  parameter Real k = 2;
equation
  x = k;
end M;
