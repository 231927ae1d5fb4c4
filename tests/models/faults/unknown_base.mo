model M
  extends Analogon.Interfaces.PartialTwoFlange;
end M;
