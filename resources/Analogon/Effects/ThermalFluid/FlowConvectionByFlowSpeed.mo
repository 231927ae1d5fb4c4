within Analogon.Effects.ThermalFluid;
model FlowConvectionByFlowSpeed "Convection in a measured stream that depends on a second recorded flow"
  extends Analogon.ThermalFluid.PartialThermalFluid;
  Analogon.Interfaces.RealInput speed(unit="km/h") "Speed of the stream"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  Analogon.Interfaces.RealInput u_flow "Recorded flow on the other side"
    annotation (Placement(transformation(origin={-50,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real n(unit="1", max=3) = 0 "Exponent of the flow (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real flow_ref = 1 "Flow at which the conductance is that without the effect"
    annotation (Dialog(group="Effect"));
equation
  G_c = c_o*A*noEvent(if speed > 0 then (speed/3.6)^0.78 else 0)*noEvent(max(u_flow/flow_ref, 1e-3))^n;
  annotation (
    __Analogon(effect(
      kind = "convection.flow",
      way = "specialise",
      strength = "n",
      oneSided = true,
      fixed(flow_ref = "mean(u_flow)"),
      channel = "u_flow")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{0,-100},{0,-80},{40,-80}}, color={0,0,127}, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-50,-100},{-50,-76}}, color={0,0,127}, thickness=0.5),
        Text(extent={{-66,-72},{70,-100}}, textString="flow^n", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>As ConvectionByFlowSpeed, with the conductance multiplied by a power of a second measured flow: a radiator in the wind of the car, through which a pump drives the coolant. At n = 0 that flow plays no part. Below a thousandth of flow_ref it counts as that.</p>
<pre>
  G_c = c_o*A*(speed/3.6)^0.78*(u_flow/flow_ref)^n
</pre>
</html>"));
end FlowConvectionByFlowSpeed;
