within Analogon.Interfaces;
connector TranslationalFlange_a "Translational flange (filled: the side that usually drives)"
  Real s(unit="m") "Position of the rod";
  flow Real f(unit="N") "Force into the component";
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{100,100}}, lineColor={0,127,0}, fillColor={0,127,0}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>One end of a rod: the position s is the same for all that is connected, the forces f into the components sum to zero.</p>
</html>"));
end TranslationalFlange_a;
