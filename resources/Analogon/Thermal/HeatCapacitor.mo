within Analogon.Thermal;
model HeatCapacitor "Body of uniform temperature"
  Analogon.Interfaces.HeatPort_a port "The body"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Real C(unit="J/K", min=0) = 1 "Heat capacity"
    annotation (Dialog(group="Parameters"));
  parameter Real T_start(unit="K", displayUnit="degC", min=0) = 293.15 "Temperature at the start"
    annotation (Dialog(group="Start values"));
  Real T(unit="K", displayUnit="degC", start=T_start, fixed=true, nominal=300) "Temperature";
equation
  T = port.T;
  C*der(T) = port.Q_flow;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Polygon(points={{0,72},{-30,64},{-56,40},{-70,4},{-62,-36},{-34,-66},{4,-74},{44,-64},{70,-28},{68,16},{46,52},{22,66}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid, smooth=Smooth.Bezier),
        Text(extent={{-60,20},{60,-20}}, textString="C", textColor={191,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A body that stores heat and has one temperature throughout.</p>
<pre>
  C*der(T) = port.Q_flow
  T = port.T,  T(0) = T_start
</pre>
</html>"));
end HeatCapacitor;
