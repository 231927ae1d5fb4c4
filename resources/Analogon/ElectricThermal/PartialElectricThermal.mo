within Analogon.ElectricThermal;
partial model PartialElectricThermal "Connectors and parameters of a resistor that heats"
  Analogon.Interfaces.RealInput v(unit="V") "Voltage at the terminals"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.RealOutput i(unit="A") "Current drawn"
    annotation (Placement(transformation(origin={0,100}, extent={{-10,-10},{10,10}}, rotation=90)));
  Analogon.Interfaces.HeatPort_b heatPort "Place that is heated"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real R(unit="Ohm", min=0) = 1 "Resistance at T_ref"
    annotation (Dialog(group="Parameters"));
  parameter Real alpha(unit="1/K") = 0 "Temperature coefficient of the resistance"
    annotation (Dialog(group="Parameters"));
  parameter Real T_ref(unit="K", displayUnit="degC", min=0) = 293.15 "Temperature at which the resistance is R"
    annotation (Dialog(group="Parameters"));
  Real R_T(unit="Ohm", start=1) "Resistance at the present temperature";
equation
  R_T = R*(1 + alpha*(heatPort.T - T_ref));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={0,0,127}),
        Line(points={{70,0},{100,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{0,40},{0,100}}, color={0,0,127}),
        Rectangle(extent={{-70,40},{70,-40}}, lineColor={0,0,0}, fillColor={250,236,214}, fillPattern=FillPattern.Solid, radius=6),
        Line(points={{-70,0},{-54,0},{-45,24},{-27,-24},{-9,24},{9,-24},{27,24},{45,-24},{54,0},{70,0}}, color={214,146,84}, thickness=1),
        Line(points={{-40,-48},{-48,-62},{-32,-74},{-40,-90}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{0,-48},{-8,-62},{8,-74},{0,-90}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{40,-48},{32,-62},{48,-74},{40,-90}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Text(extent={{-150,-110},{150,-150}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of the heaters. A class that extends it adds one equation for the current and one for the heat.</p>
<pre>
  R_T = R*(1 + alpha*(heatPort.T - T_ref))
</pre>
</html>"));
end PartialElectricThermal;
