model M
  Analogon.Thermal.HeatCapacitor mass[3](C = 5);
end M;
