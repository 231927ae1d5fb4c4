model M
  model Disc
    extends Analogon.Mechanics.Inertia(final J = 1e-3);
  end Disc;
  Disc disc(J = 2e-3);
end M;
