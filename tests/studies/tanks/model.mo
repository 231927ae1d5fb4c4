connector Surface "Surface of a liquid: its level, and what flows in, in volts of the level sensor"
  Real h(unit="V") "Level";
  flow Real q(unit="V/s") "Inflow";
end Surface;

model Tank "Open tank"
  parameter Real h_start(unit="V") = 5 "Level at the start";
  Surface surface annotation (Placement(transformation(extent={{-10,90},{10,110}})));
equation
  der(surface.h) = surface.q;
initial equation
  surface.h = h_start;
end Tank;

model Outlet "Outlet through the bottom, after Bernoulli"
  parameter Real k(min=0) = 0.05 "Outflow at a level of 1 [V^0.5/s]";
  Surface from annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Surface to annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  from.q = k*sqrt(max(from.h, 1e-6));
  to.q = -from.q;
end Outlet;

model Drain "Outlet into the reservoir, after Bernoulli"
  parameter Real k(min=0) = 0.05 "Outflow at a level of 1 [V^0.5/s]";
  Surface from annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
equation
  from.q = k*sqrt(max(from.h, 1e-6));
end Drain;

model Pump "Flow in proportion to the voltage"
  parameter Real k = 0.05;
  Analogon.Interfaces.RealInput u(unit="V") annotation (Placement(transformation(extent={{-120,-10},{-100,10}})));
  Surface port annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  port.q = -k*u;
end Pump;

model CascadedTanks "Pump, upper tank, lower tank"
  Analogon.Interfaces.RealInput u(unit="V");
  output Real y(unit="V") = lower.surface.h;
  Pump pump;
  Tank upper;
  Outlet outlet;
  Tank lower;
  Drain drain;
equation
  connect(u, pump.u);
  connect(pump.port, upper.surface);
  connect(upper.surface, outlet.from);
  connect(outlet.to, lower.surface);
  connect(lower.surface, drain.from);
end CascadedTanks;
