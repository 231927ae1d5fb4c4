model M
  block Rest
    Real y = 1;
  end Rest;
  Rest rest;
equation
  initialState(rest);
  transition(rest, rest, time > 1);
end M;
