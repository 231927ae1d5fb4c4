within Analogon.Interfaces;
partial model PartialTwoFlanges "Two flanges"
  Analogon.Interfaces.Flange_a flange_a "Left side of the shaft"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.Flange_b flange_b "Right side of the shaft"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of components between two flanges. A class that extends it adds two equations for angles and torques.</p>
</html>"));
end PartialTwoFlanges;
