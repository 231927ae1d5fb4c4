within Analogon.Tables;
function linear "Straight lines between points"
  input Real x "Abscissa at which the value is wanted";
  input Real xs[:] "Abscissas of the points, rising";
  input Real ys[size(xs, 1)] "Ordinates of the points";
  output Real y "Value";
protected
  Integer i "Piece that holds x";
algorithm
  i := 1;
  while i < size(xs, 1) - 1 and x >= xs[i + 1] loop
    i := i + 1;
  end while;
  y := if size(xs, 1) == 1 then ys[1] else ys[i] + (ys[i + 1] - ys[i])/(xs[i + 1] - xs[i])*(x - xs[i]);
  annotation (
    __Analogon(builtin = true),
    Documentation(info="<html>
<p>The program knows this function itself, with its derivative; the algorithm is for other tools.</p>
</html>"));
end linear;
