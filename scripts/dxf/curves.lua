-- dxf/curves.lua: the entities of a DXF that may be parts of loops, as points or exact shapes, for dxf.lua.
local entities = require "dxf.entities"
local first, refuse = entities.first, entities.refuse

-- A function of an entity and the tolerance for each type. It returns a chain, { points =, closed = }, or
-- { shape =, centre =, reach =, area = } for what is exact; `reach` is half its size along x and y.
local readers = {}

-- Refuses an entity of another plane.
local function check_flat(entity)
  if entity[230] and math.abs(entity[230][1] - 1) > 1e-9 then
    refuse(entity.line, entity.type .. " lies in another plane (extrusion along z must be 1)")
  end
end

-- Adds points of an elliptical arc around a centre, from t0 to t1 (rad), without its first point.
local function add_arc(points, cx, cy, ax, ay, ratio, t0, t1, tolerance)
  local radius = math.sqrt(ax*ax + ay*ay)
  local step = 2*math.acos(math.max(0, 1 - tolerance/math.max(radius, tolerance)))
  local quarter = math.ceil(math.pi/2/math.max(step, 1e-3)) -- whole quarters end at points
  local count = math.max(1, math.ceil(math.abs(t1 - t0)/(math.pi/2)*quarter - 1e-9))
  for k = 1, count do
    local t = t0 + (t1 - t0)*k/count
    local c, s = math.cos(t), math.sin(t)*ratio
    points[#points + 1] = { cx + ax*c - ay*s, cy + ay*c + ax*s }
  end
end

-- Adds the arc of a bulge (the tangent of a quarter of its angle, positive anticlockwise) up to `to`.
local function add_side(points, from, to, bulge, tolerance)
  if bulge and bulge ~= 0 and (from[1] ~= to[1] or from[2] ~= to[2]) then
    local dx, dy = to[1] - from[1], to[2] - from[2]
    local q = (1 - bulge*bulge)/(4*bulge)
    local cx, cy = from[1] + dx/2 - q*dy, from[2] + dy/2 + q*dx
    local t0 = math.atan(from[2] - cy, from[1] - cx)
    local radius = math.sqrt((from[1] - cx)^2 + (from[2] - cy)^2)
    add_arc(points, cx, cy, radius, 0, 1, t0, t0 + 4*math.atan(bulge), tolerance)
    points[#points] = to
  else
    points[#points + 1] = to
  end
end

-- Returns the points of a chain of corners with bulges; closed ones do not repeat the first.
local function chain_of(corners, bulges, closed, tolerance)
  local points = { corners[1] }
  for k = 2, #corners do add_side(points, corners[k - 1], corners[k], bulges[k - 1], tolerance) end
  if closed then
    add_side(points, corners[#corners], corners[1], bulges[#corners], tolerance)
    points[#points] = nil
  end
  return points
end

local function corners_of(entity)
  local corners = {}
  for k, x in ipairs(entity[10] or {}) do
    local y = entity[20] and entity[20][k]
    if not y then refuse(entity.line, entity.type .. " has a corner without y") end
    corners[k] = { x, y }
  end
  if #corners < 2 then refuse(entity.line, entity.type .. " has less than two corners") end
  return corners
end

local function is_closed(entity) return first(entity, 70, 0) % 2 == 1 end

function readers.LINE(e)
  return { points = { { first(e, 10), first(e, 20) }, { first(e, 11), first(e, 21) } } }
end

function readers.LWPOLYLINE(e, tolerance)
  return { points = chain_of(corners_of(e), e.bulges or {}, is_closed(e), tolerance), closed = is_closed(e) }
end

function readers.CIRCLE(e)
  local centre, radius = { first(e, 10), first(e, 20) }, first(e, 40)
  return { shape = { centre = centre, radius = radius }, centre = centre, reach = { radius, radius },
           area = math.pi*radius^2 }
end

function readers.ARC(e, tolerance)
  local x, y, radius = first(e, 10), first(e, 20), first(e, 40)
  local from, to = math.rad(first(e, 50)), math.rad(first(e, 51))
  to = from + (to - from) % (2*math.pi)
  local points = { { x + radius*math.cos(from), y + radius*math.sin(from) } }
  add_arc(points, x, y, radius, 0, 1, from, to, tolerance)
  return { points = points }
end

function readers.ELLIPSE(e, tolerance)
  local x, y, ax, ay, ratio = first(e, 10), first(e, 20), first(e, 11), first(e, 21), first(e, 40)
  local from, to = first(e, 41, 0), first(e, 42, 2*math.pi)
  local a = math.sqrt(ax*ax + ay*ay)
  if math.abs(to - from) > 2*math.pi - 1e-6 then
    local reach = { math.sqrt(ax^2 + (ratio*ay)^2), math.sqrt(ay^2 + (ratio*ax)^2) }
    return { shape = { centre = { x, y }, radii = { a, a*ratio }, angle = math.atan(ay, ax) }, centre = { x, y },
             reach = reach, area = math.pi*a^2*ratio }
  end
  local c, s = math.cos(from), math.sin(from)*ratio
  local points = { { x + ax*c - ay*s, y + ay*c + ax*s } }
  add_arc(points, x, y, ax, ay, ratio, from, from + (to - from) % (2*math.pi), tolerance)
  return { points = points }
end

return { readers = readers, check_flat = check_flat }
