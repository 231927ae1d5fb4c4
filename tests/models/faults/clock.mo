connector Tick = input Clock;
model M
  Tick tick;
end M;
