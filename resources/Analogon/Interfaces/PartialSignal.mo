within Analogon.Interfaces;
partial block PartialSignal "One signal in, one signal out"
  Analogon.Interfaces.RealInput u "Signal in"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.RealOutput y "Signal out"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of blocks with one input and one output. A class that extends it adds one equation for y.</p>
</html>"));
end PartialSignal;
