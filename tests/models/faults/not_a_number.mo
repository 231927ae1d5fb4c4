model M
  parameter Real zeta = 1.2 "damping ratio";
  parameter Real w = sqrt(1 - zeta^2);
  Real x(start = 1, fixed = true);
equation
  der(x) = -w*x;
end M;
