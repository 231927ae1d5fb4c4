within Analogon.ElectricMechanical;
partial model PartialElectricMechanical "Connectors and parameters of an electric machine"
  Analogon.Interfaces.RealInput v(unit="V") "Voltage at the terminals"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.RealOutput i(unit="A") "Current drawn"
    annotation (Placement(transformation(origin={0,100}, extent={{-10,-10},{10,10}}, rotation=90)));
  Analogon.Interfaces.Flange_b flange "Shaft"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real R(unit="Ohm", min=0) = 1 "Resistance of the winding"
    annotation (Dialog(group="Parameters"));
  parameter Real L(unit="H", min=0) = 1e-3 "Inductance of the winding"
    annotation (Dialog(group="Parameters"));
  parameter Real k(unit="N.m/A", min=0) = 0.02 "Torque constant, equal to the voltage constant"
    annotation (Dialog(group="Parameters"));
  Real w(unit="rad/s") "Speed of the shaft";
equation
  w = der(flange.phi);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-66,0}}, color={0,0,127}),
        Rectangle(extent={{56,8},{100,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-40,86},{40,60}}, lineColor={0,0,0}, fillColor={214,146,84}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-40,-60},{40,-86}}, lineColor={0,0,0}, fillColor={214,146,84}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-66,66},{66,-66}}, lineColor={0,0,0}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-80,26},{-60,-26}}, lineColor={0,0,0}, fillColor={96,96,96}, fillPattern=FillPattern.Solid),
        Line(points={{0,66},{0,100}}, color={0,0,127}),
        Text(extent={{-150,-110},{150,-150}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of the electric machines. A class that extends it adds one equation for the voltage and one for the torque.</p>
<pre>
  w = der(flange.phi)
</pre>
</html>"));
end PartialElectricMechanical;
