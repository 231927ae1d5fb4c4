model M
  parameter Real resistance(unit = "Ohm") = 2;
  Real i(unit = "A");
equation
  resistence*i = 12;
end M;
