within Analogon;
package Electric "Electrical circuits: resistors, coils, capacitors, diodes and switches"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Line(points={{-90,-20},{-60,-20}}, color={0,0,255}, thickness=1),
        Rectangle(extent={{-60,0},{40,-40}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{40,-20},{70,-20}}, color={0,0,255}, thickness=1)}),
    Documentation(info="<html>
<p>Components between pins, and the conversion that joins a circuit to a shaft. A pin carries the potential v and the flow i, as in the Modelica Standard Library; every circuit needs a ground.</p>
</html>"));
end Electric;
