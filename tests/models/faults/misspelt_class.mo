model M
  Analogon.Mechanics.Inertja rotor(J = 1e-4);
end M;
