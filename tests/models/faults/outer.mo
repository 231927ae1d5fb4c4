model M
  outer Real T_amb;
  Real x = T_amb;
end M;
