within Analogon.ThermalFluid;
partial model PartialThermalFluid "Body with heat capacity in a stream, without its law of convection"
  Analogon.Interfaces.HeatPort_a solid(T(start=T_start, fixed=true)) "The body"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b fluid "The stream"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real C(unit="J/K", min=0) = 1 "Heat capacity of the body"
    annotation (Dialog(group="Parameters"));
  parameter Real c_o(unit="W/(m2.K)", min=0) = 1 "Coefficient of the law of convection"
    annotation (Dialog(group="Parameters"));
  parameter Real A(unit="m2", min=0) = 1e-3 "Surface in the stream"
    annotation (Dialog(group="Parameters"));
  parameter Real T_start(unit="K", displayUnit="degC", min=0) = 293.15 "Temperature of the body at the start"
    annotation (Dialog(group="Start values"));
  Real G_c(unit="W/K") "Conductance of the convection";
  Real Q_flow(unit="W") "Heat from the body to the stream";
  Real dT(unit="K") "Body against stream";
equation
  dT = solid.T - fluid.T;
  Q_flow = G_c*dT;
  C*der(solid.T) = solid.Q_flow - Q_flow;
  fluid.Q_flow = -Q_flow;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-70,70},{-10,-70}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid, radius=4),
        Line(points={{-100,0},{-70,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{10,70},{70,-70}}, lineColor={0,127,255}, fillColor={218,236,252}, fillPattern=FillPattern.Solid, radius=4),
        Line(points={{70,0},{100,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{18,-50},{32,-36},{46,-64},{62,-50}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{18,-17},{32,-3},{46,-31},{62,-17}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{18,17},{32,31},{46,3},{62,17}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{18,50},{32,64},{46,36},{62,50}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-34,-34},{32,-34}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-34,0},{32,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-34,34},{32,34}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of the bodies in a stream. A class that extends it adds one equation for the conductance G_c.</p>
<pre>
  Q_flow = G_c*(solid.T - fluid.T)
  C*der(solid.T) = solid.Q_flow - Q_flow
  fluid.Q_flow = -Q_flow
  solid.T(0) = T_start
</pre>
</html>"));
end PartialThermalFluid;
