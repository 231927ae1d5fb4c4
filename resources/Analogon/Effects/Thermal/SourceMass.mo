within Analogon.Effects.Thermal;
model SourceMass "Mass of the heated element itself"
  Analogon.Interfaces.HeatPort_a port_a "Source of heat"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b port_b "Heated body"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real tau_s(unit="s", min=0) = 0 "Time constant C_s/G_s with which the element passes its heat on (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real C_s(unit="J/K", min=0) = 0 "Heat capacity of the element (0: small against that of the body)"
    annotation (Dialog(group="Effect"));
  final parameter Real G_s(unit="W/K") = if tau_s > 0 then C_s/tau_s else 0 "Conductance to the body: follows from the two above";
  final parameter Real R_s(unit="K/W") = if C_s > 0 then tau_s/C_s else 0 "Its inverse (0 while the capacity is small)";
  Real Q_flow(unit="W") "Heat that the element passes on";
  Real T(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of the body";
  Real T_s(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of the element";
initial equation
  Q_flow = port_a.Q_flow;
equation
  T = port_b.T;
  T_s = T + R_s*Q_flow;
  port_a.T = T_s;
  tau_s*der(Q_flow) = port_a.Q_flow - Q_flow - C_s*der(T);
  port_b.Q_flow = -Q_flow;
  annotation (
    __Analogon(effect(
      kind = "thermal.source_mass",
      way = "insert",
      ports = {"port_a", "port_b"},
      behindSource = true,
      strength = "tau_s",
      oneSided = true,
      secant = {"0.25*sample", "2*sample", "12*sample", "60*sample"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,40},{0,-40}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Text(extent={{-60,20},{0,-20}}, textString="C_s", textColor={191,0,0}),
        Line(points={{0,0},{100,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The element that turns power into heat (a cartridge, a winding, a wire) stores heat itself, and passes it on to the body through a conductance G_s. As long as nothing depends on the temperature of the element, only its time constant C_s/G_s can be told.</p>
<pre>
  C_s*der(T_s) = port_a.Q_flow - Q_flow
  Q_flow = G_s*(T_s - port_b.T),  tau_s = C_s/G_s
</pre>
<p>With C_s = 0 the capacity is small against that of the body: tau_s*der(Q_flow) = port_a.Q_flow - Q_flow, and the element is not told to be hotter. It begins in balance with its source.</p>
</html>"));
end SourceMass;
