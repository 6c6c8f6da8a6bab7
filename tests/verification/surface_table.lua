-- surface_table.lua: errors of closed forms without and with the correction of surfaces, as a table in Markdown.
--
-- Bodies that are thin against the horizon, each at two spacings: E of a bar in tension, the deflection of a
-- cantilever (Timoshenko), the widening of a ring under inner pressure (Lame), the first longitudinal frequency of a
-- free bar (Rayleigh and Love). E is the material's, nu 1/3. The same bodies, as tests:
-- surface_test.cpp; the table: src/lattice/README.md 3.10.
--
--   hackle run tests/verification/surface_table.lua -q

local o = options { m = 3, rows = 10, radius = 20, quadrature = "full" }
local E, rho, h, load = 65*GPa, 2235, 10*mm, 10*kPa

local function numerics(dx, surface)
  return { spacing = dx, horizon = o.m*dx, quadrature = o.quadrature, surface = surface }
end

-- The two nodes at mid-height.
local function middle(s, x)
  return s:at({x, 0.49*h}), s:at({x, 0.51*h})
end

local function bar(rows, surface)
  local dx = h/rows
  local p = plate { width = 10*h, height = h, material = "duran50" }
  p:clamp { edge = "left", depth = dx, axis = "x" }
  p:traction { edge = "right", stress = {load, 0} }
  local s = simulate(p, numerics(dx, surface))
  s:relax { tolerance = 1e-9 }
  local a, b = s:at({2.5*h, h/2}), s:at({7.5*h, h/2})
  return load/((b.ux - a.ux)/(b.x - a.x))/E - 1
end

local function cantilever(rows, surface)
  local dx = h/rows
  local p = plate { width = 8*h + o.m*dx, height = h, material = "duran50" }
  p:clamp { edge = "left", depth = o.m*dx }
  p:traction { edge = "right", stress = {0, load} }
  local s = simulate(p, numerics(dx, surface))
  s:relax { tolerance = 1e-9 }
  local a, b = middle(s, 8*h + o.m*dx - dx/2)
  local l, force, I, G = 8*h - dx/2, load*h, h^3/12, E/(2*(1 + 1/3))
  return 0.5*(a.uy + b.uy)/(force*l^3/(3*E*I) + 1.2*force*l/(G*h)) - 1
end

local function ring(cells, surface)
  local outer, inner = 20*mm, 10*mm
  local dx = outer/cells
  local half = outer + dx
  local p = plate { width = 2*half, height = 2*half, material = "duran50" }
  p:keep { centre = {half, half}, radius = outer }
  p:hole { centre = {half, half}, radius = inner, name = "bore" }
  p:pressure { rim = "bore", pressure = load }
  local s = simulate(p, numerics(dx, surface))
  s:relax { tolerance = 1e-9 }
  local got, wanted, seen = 0, 0, {}
  for k = 0, 719 do
    local x, y = math.cos(k*math.pi/360), math.sin(k*math.pi/360)
    local n = s:at({half + 0.5*(inner + outer)*x, half + 0.5*(inner + outer)*y})
    local key = n.x .. " " .. n.y
    if not seen[key] then
      seen[key] = true
      local dx_, dy_ = n.x - half, n.y - half
      local r = math.sqrt(dx_^2 + dy_^2)
      got = got + (n.ux*dx_ + n.uy*dy_)/r
      wanted = wanted + load*inner^2/(outer^2 - inner^2)*((2/3)*r + (4/3)*outer^2/r)/E
    end
  end
  return got/wanted - 1
end

local function frequency(rows, surface)
  local l, dx = 6*h, h/rows
  local p = plate { width = l, height = h, material = "duran50" }
  local k = math.pi/l
  p:initial { velocity = function(x, y)
    return -1e-4*math.cos(k*x), -1e-4/3*k*(y - h/2)*math.sin(k*x)
  end }
  local s = simulate(p, numerics(dx, surface))
  local wanted = l/(math.sqrt(E/rho)*(1 - (math.pi*h/(3*l))^2/24))  -- half a period
  local function apart()
    local sum = 0
    for row = 1, rows do
      sum = sum + s:at({l, (row - 0.5)*dx}).ux - s:at({0, (row - 0.5)*dx}).ux
    end
    return sum
  end
  while s.time < 0.8*wanted do s:step(1) end
  local before, now = apart(), apart()
  while now*before > 0 and s.time < 1.5*wanted do
    before = now
    s:step(1)
    now = apart()
  end
  return wanted/(s.time - s.dt*now/(now - before)) - 1
end

local cases = {
  { "bar: E", bar, o.rows }, { "cantilever: deflection", cantilever, o.rows },
  { "ring: widening", ring, o.radius }, { "bar: frequency", frequency, o.rows } }
print(string.format("| m = %g, %s | none | volume | energy |\n| --- | --- | --- | --- |", o.m, o.quadrature))
for _, case in ipairs(cases) do
  for _, n in ipairs { case[3], 2*case[3] } do
    local line = string.format("| %s, %d |", case[1], n)
    for _, surface in ipairs { "none", "volume", "energy" } do
      line = line .. string.format(" %+.1f %% |", 100*case[2](n, surface))
    end
    print(line)
  end
end
