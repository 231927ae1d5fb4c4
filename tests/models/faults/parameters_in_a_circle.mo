model M
  parameter Real a = b + 1;
  parameter Real b = c;
  parameter Real c = 2*a;
  Real x = a;
end M;
