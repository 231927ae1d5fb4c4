model M
  input Real phi_in(unit = "rad");
  parameter Real J(unit = "kg.m2") = 1e-3;
  Real phi(unit = "rad");
  Real w(unit = "rad/s");
  output Real tau(unit = "N.m");
equation
  phi = phi_in;
  w = der(phi);
  tau = J*der(w);
end M;
