within Analogon.Interfaces;
connector RealOutput = output Real "A signal that is given out"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Polygon(points={{-100,100},{100,0},{-100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>A real signal, computed by the block.</p>
</html>"));
