within Analogon;
package MechanicThermal "Mechanical and thermal domain: bearings and brakes"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-70,0},{50,-20}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-40,30},{20,0}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>BasicMechanicThermal is the basic class: friction on a shaft whose loss heats a place. Extensions inherit from PartialMechanicThermal.</p>
</html>"));
end MechanicThermal;
