model M "a motor
  Real x = 1;
end M;
