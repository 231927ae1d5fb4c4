model M
  parameter Real C(unit = "J/K");
  Real T(unit = "K", start = 300, fixed = true);
equation
  C*der(T) = -1;
end M;
