within Analogon;
package ElectricMechanical "Electrical and mechanical domain: motors"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-65,-65},{35,35}}, lineColor={0,0,255}, fillColor={236,236,248}, fillPattern=FillPattern.Solid),
        Text(extent={{-65,-40},{35,10}}, textString="M", textColor={0,0,255})}),
    Documentation(info="<html>
<p>BasicElectricMechanical is the basic class: a direct-current machine with permanent field. Extensions inherit from PartialElectricMechanical and so keep connectors and parameters.</p>
</html>"));
end ElectricMechanical;
