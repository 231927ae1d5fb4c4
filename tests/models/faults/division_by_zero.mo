model M
  parameter Real T_amb(unit = "K") = 293.15;
  parameter Real G(unit = "W/K") = 0 "set to 0 by mistake";
  parameter Real R = 1/G;
  Real T(unit = "K", start = 300, fixed = true);
equation
  10*der(T) = (T_amb - T)/R;
  annotation (experiment(StopTime = 1));
end M;
