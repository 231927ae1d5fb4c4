package InitialValueProblems
  "Problems with known solutions: F. Mazzia and C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4"

  model Robertson "Three reactions, rates over nine decades"
    output Real y1(start = 1, fixed = true);
    output Real y2(start = 0, fixed = true, nominal = 1e-5);
    output Real y3(start = 0, fixed = true);
    parameter Real k1 = 0.04;
    parameter Real k2 = 3e7;
    parameter Real k3 = 1e4;
  equation
    der(y1) = -k1*y1 + k3*y2*y3;
    der(y2) = k1*y1 - k2*y2^2 - k3*y2*y3;
    der(y3) = k2*y2^2;
  end Robertson;

  model RobertsonConserved "The same as a differential-algebraic system"
    output Real y1(start = 1, fixed = true);
    output Real y2(start = 0, fixed = true, nominal = 1e-5);
    output Real y3;
    parameter Real k1 = 0.04;
    parameter Real k2 = 3e7;
    parameter Real k3 = 1e4;
  equation
    der(y1) = -k1*y1 + k3*y2*y3;
    der(y2) = k1*y1 - k2*y2^2 - k3*y2*y3;
    0 = y1 + y2 + y3 - 1;
  end RobertsonConserved;

  model VanDerPol
    output Real y1(start = 2, fixed = true);
    output Real y2(start = 0, fixed = true);
    parameter Real mu = 1000;
  equation
    der(y1) = y2;
    der(y2) = mu*(1 - y1^2)*y2 - y1;
  end VanDerPol;

  model Hires "High irradiance response of plants"
    output Real y1(start = 1, fixed = true);
    output Real y2(start = 0, fixed = true);
    output Real y3(start = 0, fixed = true);
    output Real y4(start = 0, fixed = true);
    output Real y5(start = 0, fixed = true);
    output Real y6(start = 0, fixed = true);
    output Real y7(start = 0, fixed = true);
    output Real y8(start = 0.0057, fixed = true);
    parameter Real e = 280;
    parameter Real s = 0.0007;
  equation
    der(y1) = -1.71*y1 + 0.43*y2 + 8.32*y3 + s;
    der(y2) = 1.71*y1 - 8.75*y2;
    der(y3) = -10.03*y3 + 0.43*y4 + 0.035*y5;
    der(y4) = 8.32*y2 + 1.71*y3 - 1.12*y4;
    der(y5) = -1.745*y5 + 0.43*y6 + 0.43*y7;
    der(y6) = -e*y6*y8 + 0.69*y4 + 1.71*y5 - 0.43*y6 + 0.69*y7;
    der(y7) = e*y6*y8 - 1.81*y7;
    der(y8) = -der(y7);
  end Hires;

  model Oregonator
    output Real y1(start = 1, fixed = true);
    output Real y2(start = 2, fixed = true);
    output Real y3(start = 3, fixed = true);
    parameter Real s = 77.27;
    parameter Real q = 8.375e-6;
    parameter Real w = 0.161;
  equation
    der(y1) = s*(y2 + y1*(1 - q*y1 - y2));
    der(y2) = (y3 - (1 + y1)*y2)/s;
    der(y3) = w*(y1 - y3);
  end Oregonator;

  model TransistorAmplifier "Two stages; a differential-algebraic system of index 1 with a singular mass matrix"
    constant Real pi = 3.14159265358979323846;
    parameter Real Ub = 6;
    parameter Real UF = 0.026;
    parameter Real a = 0.99;
    parameter Real b = 1e-6;
    parameter Real R0 = 1000;
    parameter Real R = 9000;
    parameter Real C[5] = {k*1e-6 for k in 1:5};
    parameter Real A = 0.1;
    output Real y[8](start = {0, Ub/2, Ub/2, Ub, Ub/2, Ub/2, Ub, 0});
    Real Ue;
    Real g23;
    Real g56;
  equation
    Ue = A*sin(200*pi*time);
    g23 = b*(exp((y[2] - y[3])/UF) - 1);
    g56 = b*(exp((y[5] - y[6])/UF) - 1);
    C[1]*(der(y[2]) - der(y[1])) = (y[1] - Ue)/R0;
    C[1]*(der(y[1]) - der(y[2])) = y[2]/R + (y[2] - Ub)/R + (1 - a)*g23;
    -C[2]*der(y[3]) = y[3]/R - g23;
    C[3]*(der(y[5]) - der(y[4])) = (y[4] - Ub)/R + a*g23;
    C[3]*(der(y[4]) - der(y[5])) = y[5]/R + (y[5] - Ub)/R + (1 - a)*g56;
    -C[4]*der(y[6]) = y[6]/R - g56;
    C[5]*(der(y[8]) - der(y[7])) = (y[7] - Ub)/R + a*g56;
    C[5]*(der(y[7]) - der(y[8])) = y[8]/R;
  end TransistorAmplifier;

  model AkzoNobel "Chemical reactions; index 1"
    parameter Real k1 = 18.7;
    parameter Real k2 = 0.58;
    parameter Real k3 = 0.09;
    parameter Real k4 = 0.42;
    parameter Real K = 34.4;
    parameter Real klA = 3.3;
    parameter Real Ks = 115.83;
    parameter Real p = 0.9;
    parameter Real H = 737;
    output Real y1(start = 0.444, fixed = true);
    output Real y2(start = 0.00123, fixed = true);
    output Real y3(start = 0, fixed = true);
    output Real y4(start = 0.007, fixed = true);
    output Real y5(start = 0, fixed = true);
    output Real y6;
    Real r1;
    Real r2;
    Real r3;
    Real r4;
    Real r5;
    Real F;
  equation
    r1 = k1*y1^4*sqrt(y2);
    r2 = k2*y3*y4;
    r3 = k2/K*y1*y5;
    r4 = k3*y1*y4^2;
    r5 = k4*y6^2*sqrt(y2);
    F = klA*(p/H - y2);
    der(y1) = -2*r1 + r2 - r3 - r4;
    der(y2) = -r1/2 - r4 - r5/2 + F;
    der(y3) = r1 - r2 + r3;
    der(y4) = -r2 + r3 - 2*r4;
    der(y5) = r2 - r3 + r5;
    0 = Ks*y1*y4 - y6;
  end AkzoNobel;

  model Pendulum "In Cartesian coordinates; index 3"
    parameter Real L = 1;
    parameter Real g = 9.81;
    output Real x(start = 1);
    output Real y(start = 0);
    output Real vx(start = 0);
    output Real vy(start = 0);
    output Real lambda;
  equation
    der(x) = vx;
    der(y) = vy;
    der(vx) = -lambda*x;
    der(vy) = -lambda*y - g;
    x^2 + y^2 = L^2;
  end Pendulum;

  model PendulumFixed "Start values given for all four, as they are found in a book"
    extends Pendulum(x(fixed = true), y(fixed = true), vx(fixed = true), vy(fixed = true));
  end PendulumFixed;

  model DcMotor
    parameter Real R = 1.2;
    parameter Real L = 0.0008;
    parameter Real Ke = 0.05;
    parameter Real J = 2e-5;
    parameter Real b = 1e-5;
    parameter Real kf = 3e-9;
    parameter Real U = 12;
    output Real i(start = 0, fixed = true);
    output Real w(start = 0, fixed = true);
  equation
    L*der(i) = U - R*i - Ke*w;
    J*der(w) = Ke*i - b*w - kf*w*abs(w);
  end DcMotor;

  model HeatChain "Ten masses in a row, the last one against an ambient of 0"
    parameter Integer n = 10;
    Analogon.Thermal.HeatCapacitor mass[n](each C = 5, each T_start = 0);
    Analogon.Thermal.ThermalConductor conductor[n](each G = 2);
    Analogon.Sources.FixedTemperature ambient(T = 0);
    Analogon.Sources.PrescribedHeatFlow heat;
    Analogon.Sources.Constant power(k = 40);
    output Real T[n];
  equation
    connect(power.y, heat.Q_flow);
    connect(heat.port, mass[1].port);
    for i in 1:n loop
      connect(mass[i].port, conductor[i].port_a);
      T[i] = mass[i].port.T;
    end for;
    for i in 1:n - 1 loop
      connect(conductor[i].port_b, mass[i + 1].port);
    end for;
    connect(conductor[n].port_b, ambient.port);
  end HeatChain;
end InitialValueProblems;
