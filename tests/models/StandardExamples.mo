package StandardExamples
  "Examples of the Modelica Standard Library 4.1, rebuilt from blocks: what they compute is known from other tools"

  package Parts "Blocks that the library does not hold"
    model IdealGear "Gear without inertia, rigid"
      extends Analogon.Interfaces.PartialTwoFlanges;
      parameter Real ratio = 1 "flange_a.phi over flange_b.phi";
    equation
      flange_a.phi = ratio*flange_b.phi;
      0 = ratio*flange_a.tau + flange_b.tau;
    end IdealGear;

    block Sine
      parameter Real amplitude = 1;
      parameter Real frequency(unit = "Hz") = 1;
      parameter Real phase(unit = "rad") = 0;
      Analogon.Interfaces.RealOutput y;
    equation
      y = amplitude*sin(2*3.14159265358979323846*frequency*time + phase);
    end Sine;

    block Step
      parameter Real startTime(unit = "s") = 0;
      Analogon.Interfaces.RealOutput y;
    equation
      y = if time < startTime then 0 else 1;
    end Step;

    model Clutch "Dry friction under a normal force; a peak at standstill that is gone at a creeping speed"
      extends Analogon.Interfaces.PartialTwoFlanges;
      parameter Real mu = 0.5 "Friction coefficient";
      parameter Real peak = 1.1 "Over mu at standstill";
      parameter Real fn_max(unit = "N") = 20;
      parameter Real cgeo(unit = "m") = 1;
      Analogon.Interfaces.RealInput f_normalized;
      Real phi_rel(unit = "rad");
      Real w_rel(unit = "rad/s");
      Real tau(unit = "N.m");
    equation
      phi_rel = flange_b.phi - flange_a.phi;
      w_rel = der(phi_rel);
      tau = mu*cgeo*fn_max*max(f_normalized, 0)*sign(w_rel)*(1 + (peak - 1)*exp(-(w_rel/1e-3)^2));
      flange_b.tau = tau;
      flange_a.tau = -tau;
    end Clutch;

    model ElastoBacklash "A spring and damper that acts beyond a gap, and that never pulls"
      extends Analogon.Interfaces.PartialTwoFlanges;
      parameter Real c(unit = "N.m/rad") = 1e5;
      parameter Real d(unit = "N.m.s/rad") = 0;
      parameter Real b(unit = "rad") = 0 "Gap";
      Real phi_rel(unit = "rad");
      Real w_rel(unit = "rad/s");
      Real tau(unit = "N.m");
    protected
      Real tau_c(unit = "N.m");
      Real tau_d(unit = "N.m");
    equation
      phi_rel = flange_b.phi - flange_a.phi;
      w_rel = der(phi_rel);
      tau_c = if phi_rel > b/2 then c*(phi_rel - b/2) elseif phi_rel < -b/2 then c*(phi_rel + b/2) else 0;
      tau_d = d*w_rel;
      tau = if phi_rel > b/2 then (if tau_c + tau_d <= 0 then 0 else tau_c + min(tau_c, tau_d))
        elseif phi_rel < -b/2 then (if tau_c + tau_d >= 0 then 0 else tau_c + max(tau_c, tau_d)) else 0;
      flange_b.tau = tau;
      flange_a.tau = -tau;
    end ElastoBacklash;

    connector Flange "Translation"
      Real s(unit = "m");
      flow Real f(unit = "N");
    end Flange;
    partial model Compliant
      Flange flange_a;
      Flange flange_b;
      Real s_rel(unit = "m");
      Real v_rel(unit = "m/s");
      Real f(unit = "N");
    equation
      s_rel = flange_b.s - flange_a.s;
      v_rel = der(s_rel);
      flange_b.f = f;
      flange_a.f = -f;
    end Compliant;
    model Mass
      parameter Real m(unit = "kg") = 1;
      parameter Real L(unit = "m") = 0 "Length";
      Flange flange_a;
      Flange flange_b;
      Real s(unit = "m");
      Real v(unit = "m/s");
    equation
      v = der(s);
      flange_a.s = s - L/2;
      flange_b.s = s + L/2;
      m*der(v) = flange_a.f + flange_b.f;
    end Mass;
    model Support
      parameter Real s0(unit = "m") = 0;
      Flange flange;
    equation
      flange.s = s0;
    end Support;
    model Damper
      extends Compliant;
      parameter Real d(unit = "N.s/m") = 0;
    equation
      f = d*v_rel;
    end Damper;
    model Spring
      extends Compliant;
      parameter Real c(unit = "N/m") = 1;
      parameter Real s_rel0(unit = "m") = 0;
    equation
      f = c*(s_rel - s_rel0);
    end Spring;
    model SpringDamper
      extends Compliant;
      parameter Real c(unit = "N/m") = 1;
      parameter Real d(unit = "N.s/m") = 0;
      parameter Real s_rel0(unit = "m") = 0;
    equation
      f = c*(s_rel - s_rel0) + d*v_rel;
    end SpringDamper;

    connector Pin
      Real v(unit = "V");
      flow Real i(unit = "A");
    end Pin;
    partial model OnePort
      Pin p;
      Pin n;
      Real v(unit = "V");
      Real i(unit = "A");
    equation
      v = p.v - n.v;
      0 = p.i + n.i;
      i = p.i;
    end OnePort;
    model Resistor
      extends OnePort;
      parameter Real R(unit = "Ohm") = 1;
    equation
      v = R*i;
    end Resistor;
    model Capacitor
      extends OnePort(v(start = 0));
      parameter Real C(unit = "F") = 1;
    equation
      i = C*der(v);
    end Capacitor;
    model Inductor
      extends OnePort(i(start = 0));
      parameter Real L(unit = "H") = 1;
    equation
      L*der(i) = v;
    end Inductor;
    model StepVoltage
      extends OnePort;
      parameter Real V(unit = "V") = 1;
      parameter Real startTime(unit = "s") = 0;
    equation
      v = if time < startTime then 0 else V;
    end StepVoltage;
    model Ground
      Pin p;
    equation
      p.v = 0;
    end Ground;
  end Parts;

  model TwoMasses "Two heat capacities and a conductor; the final temperature is a parameter from an initial equation"
    Analogon.Thermal.HeatCapacitor mass1(C = 15, T_start = 373.15);
    Analogon.Thermal.HeatCapacitor mass2(C = 15, T_start = 273.15);
    Analogon.Thermal.ThermalConductor conduction(G = 10);
    parameter Real T_final(unit = "K", fixed = false);
  initial equation
    T_final = (mass1.T*mass1.C + mass2.T*mass2.C)/(mass1.C + mass2.C);
  equation
    connect(mass1.port, conduction.port_a);
    connect(conduction.port_b, mass2.port);
  end TwoMasses;

  model First "A drive with a rigid gear and an elastic shaft"
    Parts.Sine sine(amplitude = 10, frequency = 5);
    Analogon.Sources.PrescribedTorque torque;
    Analogon.Mechanics.Inertia inertia1(J = 0.1);
    Parts.IdealGear gear(ratio = 10);
    Analogon.Mechanics.Inertia inertia2(J = 2, phi(start = 0, fixed = true), w(start = 0, fixed = true));
    Analogon.Mechanics.SpringDamper spring(c = 1e4, d = 0);
    Analogon.Mechanics.Inertia inertia3(J = 2, phi(start = 0, fixed = true), w(start = 0, fixed = true));
    Analogon.Mechanics.SpringDamper damper(c = 0, d = 10);
    Analogon.Mechanics.Fixed fixed;
  equation
    connect(sine.y, torque.tau);
    connect(torque.flange, inertia1.flange_a);
    connect(inertia1.flange_b, gear.flange_a);
    connect(gear.flange_b, inertia2.flange_a);
    connect(inertia2.flange_b, spring.flange_a);
    connect(spring.flange_b, inertia3.flange_a);
    connect(inertia2.flange_b, damper.flange_a);
    connect(damper.flange_b, fixed.flange);
  end First;

  model Damper "Three masses braked in three ways"
    Parts.Mass mass1(m = 1, L = 1, s(start = 3, fixed = true), v(start = 10, fixed = true));
    Parts.Damper damper1(d = 25);
    Parts.Support fixed1(s0 = 4.5);
    Parts.Mass mass2(m = 1, L = 1, s(start = 3, fixed = true), v(start = 10, fixed = true));
    Parts.Damper damper2(d = 25);
    Parts.Spring spring2(c = 1, s_rel0 = 1);
    Parts.Support fixed2(s0 = 4.5);
    Parts.Mass mass3(m = 1, L = 1, s(start = 3, fixed = true), v(start = 10, fixed = true));
    Parts.SpringDamper springDamper3(c = 1, d = 25, s_rel0 = 1);
    Parts.Support fixed3(s0 = 4.5);
  equation
    connect(mass1.flange_b, damper1.flange_a);
    connect(damper1.flange_b, fixed1.flange);
    connect(mass2.flange_b, damper2.flange_a);
    connect(mass2.flange_b, spring2.flange_a);
    connect(damper2.flange_b, fixed2.flange);
    connect(spring2.flange_b, fixed2.flange);
    connect(mass3.flange_b, springDamper3.flange_a);
    connect(springDamper3.flange_b, fixed3.flange);
  end Damper;

  model Backlash "A shaft in a gap beside one without"
    constant Real pi = 3.14159265358979323846;
    Analogon.Mechanics.Inertia inertia1(J = 5, phi(start = pi/2, fixed = true), w(start = 0, fixed = true));
    Parts.ElastoBacklash elastoBacklash(c = 2e4, d = 50, b = pi/4);
    Analogon.Mechanics.Fixed fixed1;
    Analogon.Mechanics.Inertia inertia2(J = 5, phi(start = pi/2, fixed = true), w(start = 0, fixed = true));
    Analogon.Mechanics.SpringDamper springDamper(c = 2e4, d = 50);
    Analogon.Mechanics.Fixed fixed2;
  equation
    connect(fixed1.flange, elastoBacklash.flange_a);
    connect(elastoBacklash.flange_b, inertia1.flange_a);
    connect(fixed2.flange, springDamper.flange_a);
    connect(springDamper.flange_b, inertia2.flange_a);
  end Backlash;

  model CoupledClutches "Three clutches that slip and stick one after the other"
    Parts.Sine sin1(amplitude = 10, frequency = 5);
    Parts.Sine sin2(amplitude = 1, frequency = 0.2, phase = 1.57079632679489662);
    Parts.Step step1(startTime = 0.4);
    Parts.Step step2(startTime = 0.9);
    Analogon.Sources.PrescribedTorque torque;
    Analogon.Mechanics.Inertia J1(J = 1, phi(start = 0, fixed = true), w(start = 10, fixed = true));
    Parts.Clutch clutch1;
    Analogon.Mechanics.Inertia J2(J = 1, phi(start = 0, fixed = true), w(start = 0, fixed = true));
    Parts.Clutch clutch2;
    Analogon.Mechanics.Inertia J3(J = 1, phi(start = 0, fixed = true), w(start = 0, fixed = true));
    Parts.Clutch clutch3;
    Analogon.Mechanics.Inertia J4(J = 1, phi(start = 0, fixed = true), w(start = 0, fixed = true));
  equation
    connect(sin1.y, torque.tau);
    connect(torque.flange, J1.flange_a);
    connect(J1.flange_b, clutch1.flange_a);
    connect(clutch1.flange_b, J2.flange_a);
    connect(J2.flange_b, clutch2.flange_a);
    connect(clutch2.flange_b, J3.flange_a);
    connect(J3.flange_b, clutch3.flange_a);
    connect(clutch3.flange_b, J4.flange_a);
    connect(sin2.y, clutch1.f_normalized);
    connect(step1.y, clutch2.f_normalized);
    connect(step2.y, clutch3.f_normalized);
  end CoupledClutches;

  model CauerLowPassAnalog "A filter of order five from seven storage elements: two loops of capacitors"
    Parts.StepVoltage source(V = 1, startTime = 1);
    Parts.Ground ground;
    Parts.Resistor R1(R = 1);
    Parts.Resistor R2(R = 1);
    Parts.Capacitor C1(C = 1.072);
    Parts.Capacitor C2(C = 1/(1.704992^2*1.304));
    Parts.Capacitor C3(C = 1.682);
    Parts.Capacitor C4(C = 1/(1.179945^2*0.8586));
    Parts.Capacitor C5(C = 0.7262);
    Parts.Inductor L1(L = 1.304);
    Parts.Inductor L2(L = 0.8586);
  equation
    connect(source.n, ground.p);
    connect(source.p, R1.p);
    connect(R1.n, C1.p);
    connect(C1.n, ground.p);
    connect(C1.p, L1.p);
    connect(L1.n, C3.p);
    connect(C2.p, L1.p);
    connect(C2.n, L1.n);
    connect(C3.n, ground.p);
    connect(C3.p, L2.p);
    connect(L2.n, C5.p);
    connect(C4.p, L2.p);
    connect(C4.n, L2.n);
    connect(C5.n, ground.p);
    connect(R2.p, C5.p);
    connect(R2.n, ground.p);
  end CauerLowPassAnalog;
end StandardExamples;
