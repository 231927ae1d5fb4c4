model M
  model Box
    Real y = inside;
  protected
    Real inside = 1;
  end Box;
  Box box;
  Real x = box.inside;
end M;
