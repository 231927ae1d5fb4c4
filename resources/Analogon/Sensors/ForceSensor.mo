within Analogon.Sensors;
model ForceSensor "Ideal force sensor between two flanges"
  extends Analogon.Interfaces.PartialTwoTranslationalFlanges;
  Analogon.Interfaces.RealOutput f(unit="N") "Force that the rod passes on from flange_a to flange_b"
    annotation (Placement(transformation(origin={0,-100}, extent={{-10,-10},{10,10}}, rotation=-90)));
equation
  flange_a.s = flange_b.s;
  flange_a.f + flange_b.f = 0;
  f = flange_a.f;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{0,-50},{0,-100}}, color={0,0,127}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Text(extent={{-36,30},{36,-30}}, textString="f", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Passes position and force on unchanged and tells the force.</p>
<pre>
  flange_a.s = flange_b.s
  f = flange_a.f = -flange_b.f
</pre>
</html>"));
end ForceSensor;
