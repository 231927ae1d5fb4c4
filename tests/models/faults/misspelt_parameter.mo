model M
  Analogon.Mechanics.SpringDamper shaft(c = 100, dd = 1);
end M;
