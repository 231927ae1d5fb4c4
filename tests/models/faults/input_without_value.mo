model Law
  input Real u;
  output Real y;
equation
  y = 2*u;
end Law;

model M
  Law law;
equation
  law.u = 3;
end M;
