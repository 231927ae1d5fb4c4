package Events "Models whose equations switch"
  model BouncingBall
    "Without a jump: s unfolds the height at the ground and z is its speed, scaled so that it runs on (Ivanov 1993)"
    parameter Real e = 0.7 "Speed after a bounce over that before";
    parameter Real g(unit = "m/s2") = 9.81;
    output Real h "Height";
    output Real v "Speed, upwards";
    output Real s(start = 1, fixed = true);
  protected
    parameter Real k = (1 - e)/(1 + e);
    Real z(start = 0, fixed = true);
    Real side;
    Real scale;
  equation
    side = if s > 0 then 1 else -1;
    scale = if s*z > 0 then 1 - k else 1 + k;
    der(s) = scale*z;
    der(z) = -side*g/scale;
    h = abs(s);
    v = side*scale*z;
  end BouncingBall;

  model CoulombOscillator "A mass on a spring with dry friction"
    parameter Real m(unit = "kg") = 1;
    parameter Real k(unit = "N/m") = 100;
    parameter Real Fc(unit = "N") = 3;
    output Real x(unit = "m", start = 0.5, fixed = true);
    output Real v(unit = "m/s", start = 0, fixed = true);
  equation
    der(x) = v;
    m*der(v) = -k*x - Fc*sign(v);
  end CoulombOscillator;

  model StickSlip "A mass on a moving belt, held by a spring; friction falls with the speed"
    parameter Real belt(unit = "m/s") = 0.1;
    output Real x(unit = "m", start = 0, fixed = true);
    output Real v(unit = "m/s", start = 0.1, fixed = true);
    Real slip(unit = "m/s");
  equation
    slip = v - belt;
    der(x) = v;
    der(v) = -100*x - (if slip > 0 then 1 else -1)*(1 + 2*exp(-abs(slip)/0.05));
  end StickSlip;

  model TwoBrakes "Two masses pressed on each other and on the ground, pulled apart ever harder"
    output Real v1(unit = "m/s", start = 1, fixed = true);
    output Real v2(unit = "m/s", start = 0, fixed = true);
  equation
    der(v1) = time - 2*sign(v1 - v2);
    der(v2) = 2*sign(v1 - v2) - 3*sign(v2);
  end TwoBrakes;

  model Thermostat "Switches without a dead band: would chatter"
    output Real T(unit = "K", start = 290, fixed = true, nominal = 300);
  equation
    der(T) = (if T < 300 then 5 else 0) - 0.05*(T - 280);
  end Thermostat;

  model DeadZone "A mass between two stops, with no friction"
    parameter Real gap(unit = "m") = 0.2;
    parameter Real c(unit = "N/m") = 1e4;
    output Real x(unit = "m", start = 0, fixed = true);
    output Real v(unit = "m/s", start = 1, fixed = true);
  equation
    der(x) = v;
    der(v) = if x > gap then -c*(x - gap) elseif x < -gap then -c*(x + gap) else 0;
  end DeadZone;

  model Chopper "Charged in half of each period"
    parameter Real f(unit = "rad/s") = 1000;
    output Real x(start = 0, fixed = true);
  equation
    der(x) = if sin(f*time) > 0 then 1 else 0;
  end Chopper;

  model Dithered "A fast one that the state takes part in"
    output Real x(start = 1, fixed = true);
  equation
    der(x) = if x + 0.5*sin(1e9*time) > 0 then -1 else 1;
  end Dithered;

  model RareAndShort "Switched on once, for a part of a step"
    output Real x(start = 0, fixed = true);
  equation
    der(x) = if abs(time - 5) < 0.8 then 1 else 0;
  end RareAndShort;
end Events;
