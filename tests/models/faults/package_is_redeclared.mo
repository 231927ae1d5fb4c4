package Fluids
  package Water
    constant Real cp(unit = "J/(kg.K)") = 4180;
    model Volume
      parameter Real m(unit = "kg") = 1;
      Real C(unit = "J/K") = m*cp;
    end Volume;
  end Water;
  package Brine = Water(cp = 3600);
end Fluids;

model M
  Fluids.Brine.Volume tank(m = 3);
end M;
