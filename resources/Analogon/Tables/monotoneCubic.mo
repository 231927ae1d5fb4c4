within Analogon.Tables;
function monotoneCubic "Smooth curve through points, which rises and falls only where they do"
  input Real x "Abscissa at which the value is wanted";
  input Real xs[:] "Abscissas of the points, rising";
  input Real ys[size(xs, 1)] "Ordinates of the points";
  output Real y "Value";
protected
  Integer n = size(xs, 1);
  Integer i "Piece that holds x";
  Real secant[size(xs, 1)] "Slope of each piece";
  Real slope[size(xs, 1)] "Slope at each point";
  Real radius;
  Real a;
  Real b;
  Real h "Way from the left end of the piece";
  Real w "Width of the piece";
algorithm
  if n == 1 then
    y := ys[1];
    return;
  end if;
  for k in 1:n - 1 loop
    secant[k] := (ys[k + 1] - ys[k])/(xs[k + 1] - xs[k]);
  end for;
  slope[1] := secant[1];
  slope[n] := secant[n - 1];
  for k in 2:n - 1 loop
    slope[k] := if secant[k - 1]*secant[k] <= 0 then 0 else (secant[k - 1] + secant[k])/2;
  end for;
  for k in 1:n - 1 loop
    if secant[k] == 0 then
      slope[k] := 0;
      slope[k + 1] := 0;
    else
      a := slope[k]/secant[k];
      b := slope[k + 1]/secant[k];
      radius := sqrt(a^2 + b^2);
      if radius > 3 then
        slope[k] := 3/radius*a*secant[k];
        slope[k + 1] := 3/radius*b*secant[k];
      end if;
    end if;
  end for;
  i := 1;
  while i < n - 1 and x >= xs[i + 1] loop
    i := i + 1;
  end while;
  h := x - xs[i];
  w := xs[i + 1] - xs[i];
  if x < xs[1] then
    y := ys[1] + slope[1]*h;
  elseif x > xs[n] then
    y := ys[n] + slope[n]*(x - xs[n]);
  else
    y := ys[i] + h*(slope[i] + h*((3*secant[i] - 2*slope[i] - slope[i + 1])/w + h*(slope[i] + slope[i + 1] - 2*secant[i])/w^2));
  end if;
  annotation (
    __Analogon(builtin = true),
    Documentation(info="<html>
<p>Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246: a cubic on each piece, with slopes that keep it monotone. The program knows this function itself, with its derivative; the algorithm is for other tools.</p>
</html>"));
end monotoneCubic;
