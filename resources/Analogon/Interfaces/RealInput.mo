within Analogon.Interfaces;
connector RealInput = input Real "A signal that is read"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Polygon(points={{-100,100},{100,0},{-100,-100}}, lineColor={0,0,127}, fillColor={0,0,127}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>A real signal, read by the block. Give its unit where it is used: RealInput u(unit=&quot;V&quot;).</p>
</html>"));
