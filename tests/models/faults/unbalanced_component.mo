model M
  model Motor
    Analogon.Interfaces.Flange_b flange;
    Real i(unit = "A");
  equation
    flange.tau = -0.05*i;
  end Motor;
  Motor motor;
  Analogon.Mechanics.Inertia rotor;
equation
  connect(motor.flange, rotor.flange_a);
end M;
