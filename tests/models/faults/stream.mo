connector Port
  Real p;
  flow Real m_flow;
  stream Real h;
end Port;
model M
  Port port;
  Real x = 1;
end M;
