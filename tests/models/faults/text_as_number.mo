model M
  parameter Real R = "1.2";
  Real x = R;
end M;
