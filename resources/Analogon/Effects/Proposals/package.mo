within Analogon.Effects;
package Proposals "Equations to propose where no named effect explains what is left"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Text(extent={{-60,40},{40,-80}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Forms that compete with the named effects. Where one of them explains the measurement clearly better, none of the names fits: the search then says so, names the place and proposes the equation. It is never added by itself.</p>
</html>"));
end Proposals;
