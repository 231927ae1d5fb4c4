within Analogon.Effects.ThermalFluid;
model FlowConvection "Convection that depends on a recorded flow"
  extends Analogon.ThermalFluid.PartialThermalFluid;
  Analogon.Interfaces.RealInput u_flow "Recorded flow of the stream"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real n(unit="1", max=3) = 0 "Exponent of the flow (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real flow_ref = 1 "Flow at which the conductance is that without the effect"
    annotation (Dialog(group="Effect"));
equation
  G_c = c_o*A*(fluid.T/3.6)^0.78*noEvent(max(u_flow/flow_ref, 1e-3))^n;
  annotation (
    __Analogon(effect(
      kind = "convection.flow",
      way = "specialise",
      strength = "n",
      oneSided = true,
      fixed(flow_ref = "mean(u_flow)"),
      channel = "u_flow")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{0,-100},{0,-76}}, color={0,0,127}, thickness=0.5),
        Text(extent={{-66,-72},{70,-100}}, textString="flow^n", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>As BasicThermalFluid, with the conductance multiplied by a power of a measured flow: the speed of the gas, the throughput of a pump. At n = 0 the flow plays no part. Below a thousandth of flow_ref the flow counts as that.</p>
<pre>
  G_c = c_o*A*(fluid.T/3.6)^0.78*(u_flow/flow_ref)^n
</pre>
</html>"));
end FlowConvection;
