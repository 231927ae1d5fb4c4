within Analogon.Effects.Thermal;
model LatentHeat "Heat of evaporation taken up once"
  extends Analogon.Interfaces.PartialOneHeatPort;
  parameter Real Q_l(unit="J", min=0) = 0 "Heat of evaporation or melting (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_l(unit="K", displayUnit="degC", min=0) = 373.15 "Temperature around which it is taken up"
    annotation (Dialog(group="Effect"));
  parameter Real width(unit="K", min=1e-3) = 10 "Width of the range in which it is taken up"
    annotation (Dialog(group="Effect"));
  parameter Real t_f(unit="s", min=1e-9) = 0.1 "Time constant with which the front follows the temperature"
    annotation (Dialog(group="Numerics"));
  Real T_m(unit="K", displayUnit="degC", start=293.15, nominal=300) "Highest temperature so far";
  Real rate(unit="K/s") "Rate of the highest temperature";
  Real share(unit="1") "1 within the range, 0 outside";
initial equation
  T_m = port.T;
equation
  t_f*rate = noEvent(max(T - T_m, 0));
  der(T_m) = rate;
  share = (tanh(5*(T_m - T_l)/width + 2.5) - tanh(5*(T_m - T_l)/width - 2.5))/2;
  port.Q_flow = Q_l/width*share*rate;
  annotation (
    __Analogon(effect(
      kind = "thermal.latent",
      way = "attach",
      ports = {"port"},
      strength = "Q_l",
      oneSided = true,
      fixed(t_f = "sample"),
      shape(T_l = {"start(T) + 0.1*range(T)", "start(T) + 0.25*range(T)", "start(T) + 0.4*range(T)", "start(T) + 0.6*range(T)", "start(T) + 0.9*range(T)"}, width = {"0.06*range(T)", "0.2*range(T)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{-60,-60},{-20,-10},{20,10},{60,60}}, color={191,0,0}, thickness=0.75),
        Line(points={{-60,-60},{-60,70}}, color={128,128,128}),
        Line(points={{-60,-60},{75,-60}}, color={128,128,128}),
        Ellipse(extent={{-16,20},{16,-20}}, lineColor={0,127,255}, fillColor={218,236,252}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Moisture that evaporates, or a part that melts, on the first heating: between T_l - width/2 and T_l + width/2 the body has the extra heat capacity Q_l/width, until the heat Q_l is taken up. It does not come back on cooling.</p>
<pre>
  der(T_m)    = max(port.T - T_m, 0)/t_f        highest temperature so far
  port.Q_flow = Q_l/width*der(T_m)              while T_m is in the range
</pre>
</html>"));
end LatentHeat;
