within Analogon.Interfaces;
partial model PartialTwoPins "Two pins, the voltage between them and the current through them"
  Analogon.Interfaces.PositivePin p "Positive side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.NegativePin n "Negative side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Real v(unit="V") "Voltage from p to n";
  Real i(unit="A") "Current from p to n";
equation
  v = p.v - n.v;
  i = p.i;
  p.i + n.i = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of components between two pins. A class that extends it adds one equation for voltage and current.</p>
<pre>
  v = p.v - n.v
  i = p.i = -n.i
</pre>
</html>"));
end PartialTwoPins;
