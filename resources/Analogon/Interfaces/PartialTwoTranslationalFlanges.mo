within Analogon.Interfaces;
partial model PartialTwoTranslationalFlanges "Two translational flanges"
  Analogon.Interfaces.TranslationalFlange_a flange_a "Left side of the rod"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.TranslationalFlange_b flange_b "Right side of the rod"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of components between two translational flanges. A class that extends it adds two equations for positions and forces.</p>
</html>"));
end PartialTwoTranslationalFlanges;
