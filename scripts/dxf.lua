-- dxf.lua: outlines and holes from a drawing in DXF, as CAD programs write it (ASCII).
--
--   local part = require "dxf" { "bracket.dxf", layers = { "cut" }, unit = mm }
--   local p = plate { outline = part.outline, material = "pmma" }
--   for _, hole in ipairs(part.holes) do p:hole(hole) end
--
-- The largest closed loop is the outline, the others are holes; all are moved so that the outline begins at the origin.
-- Loops are CIRCLE, full ELLIPSE, closed LWPOLYLINE and POLYLINE, or chains of LINE, ARC, parts of ELLIPSE and open
-- polylines whose ends meet. Circles and ellipses stay exact; arcs become chords that deviate by `tolerance`.
--
--   layers     names of the layers to read; default: all
--   unit       of the drawing; default: what its header says ($INSUNITS)
--   tolerance  of arcs and of ends that meet, m; default: a 10 000th of the drawing
--
-- Texts, dimensions, points and hatches are skipped; what else is not read (SPLINE, INSERT, ...) is refused by name:
-- explode it into lines or polylines. Layers that hold no loop, loops that stay open, a loop outside of the outline and
-- all that is no DXF are errors that name the line of the file.

local entities, curves = require "dxf.entities", require "dxf.curves"
local refuse, readers = entities.refuse, curves.readers

local most_points = 10000
local units = { [1] = 25.4e-3, [2] = 0.3048, [4] = 1e-3, [5] = 1e-2, [6] = 1, [8] = 25.4e-9, [13] = 1e-6, [14] = 0.1 }
local skipped = { TEXT = true, MTEXT = true, DIMENSION = true, POINT = true, HATCH = true, LEADER = true,
                  ATTDEF = true, VIEWPORT = true, MULTILEADER = true }

-- Returns the entities on some layers; all without `layers`.
local function selected(all, layers)
  if not layers then return all end
  if type(layers) ~= "table" then layers = { layers } end
  local wanted, found, names = {}, {}, {}
  for _, layer in ipairs(layers) do wanted[layer] = true end
  local chosen = {}
  for _, e in ipairs(all) do
    if e.layer and not found[e.layer] then found[e.layer], names[#names + 1] = true, e.layer end
    if wanted[e.layer] then chosen[#chosen + 1] = e end
  end
  for _, layer in ipairs(layers) do
    if not found[layer] then
      table.sort(names)
      local some = table.concat(names, ", ", 1, math.min(#names, 20))
      refuse(nil, string.format("has nothing on layer '%s'; its layers are %s", layer, some))
    end
  end
  return chosen
end

-- Returns the entities that may be parts of loops; refuses those that might be but are not read.
local function readable(all)
  local kept = {}
  for _, e in ipairs(all) do
    if readers[e.type] then
      curves.check_flat(e)
      kept[#kept + 1] = e
    elseif not skipped[e.type] then
      refuse(e.line, e.type:sub(1, 40) .. " is not read: explode it into lines or polylines, or leave out its layer")
    end
  end
  return kept
end

-- Returns the size of the drawing, roughly: for tolerances.
local function size_of(all)
  local most = 0
  local low, high = { math.huge, math.huge }, { -math.huge, -math.huge }
  for _, e in ipairs(all) do
    for axis = 1, 2 do
      for _, code in ipairs { 10*axis, e.type == "LINE" and 10*axis + 1 or 10*axis } do
        for _, value in ipairs(e[code] or {}) do
          low[axis], high[axis] = math.min(low[axis], value), math.max(high[axis], value)
        end
      end
    end
    if e[40] then most = math.max(most, math.abs(e[40][1])) end
  end
  return math.max(high[1] - low[1], high[2] - low[2], most)
end

-- Joins chains whose ends meet to loops.
local function joined(chains, tolerance)
  local loops, ends = {}, {}
  local function key(point, i, j)
    return math.floor(point[1]/tolerance/4 + 0.5) + i .. ":" .. math.floor(point[2]/tolerance/4 + 0.5) + j
  end
  local function enter(chain, point)
    local cell = key(point, 0, 0)
    ends[cell] = ends[cell] or {}
    table.insert(ends[cell], chain)
  end
  for _, chain in ipairs(chains) do
    enter(chain, chain.points[1])
    enter(chain, chain.points[#chain.points])
  end
  local function meets(a, b) return math.abs(a[1] - b[1]) <= tolerance and math.abs(a[2] - b[2]) <= tolerance end
  local function continuation(chain, point)
    for i = -1, 1 do
      for j = -1, 1 do
        for _, other in ipairs(ends[key(point, i, j)] or {}) do
          if not other.used and other ~= chain then
            if meets(other.points[1], point) then return other, false end
            if meets(other.points[#other.points], point) then return other, true end
          end
        end
      end
    end
  end
  for _, chain in ipairs(chains) do
    if not chain.used then
      chain.used = true
      local points = table.move(chain.points, 1, #chain.points, 1, {})
      while not (meets(points[1], points[#points]) and #points > 2) do
        local other, backwards = continuation(chain, points[#points])
        if not other then
          local x, y = table.unpack(points[#points])
          refuse(chain.line, string.format("the loop that begins here stays open at (%.6g, %.6g)", x, y))
        end
        other.used = true
        local count = #other.points
        for k = 2, count do points[#points + 1] = other.points[backwards and count + 1 - k or k] end
      end
      points[#points] = nil
      loops[#loops + 1] = { points = points, line = chain.line }
    end
  end
  return loops
end

local function measure(loop)
  if loop.shape then
    local c, r = loop.centre, loop.reach
    loop.low, loop.high = { c[1] - r[1], c[2] - r[2] }, { c[1] + r[1], c[2] + r[2] }
    return
  end
  if #loop.points > most_points then refuse(loop.line, "a loop has more than 10000 points: raise the tolerance") end
  local low, high, area = { math.huge, math.huge }, { -math.huge, -math.huge }, 0
  for k, point in ipairs(loop.points) do
    local after = loop.points[k % #loop.points + 1]
    area = area + point[1]*after[2] - after[1]*point[2]
    for axis = 1, 2 do
      low[axis], high[axis] = math.min(low[axis], point[axis]), math.max(high[axis], point[axis])
    end
  end
  loop.low, loop.high, loop.area = low, high, math.abs(area)/2
end

-- Returns the area of a loop as plate and hole take it, in m, with `origin` moved to the origin.
local function placed(loop, origin, unit)
  local function moved(point) return { (point[1] - origin[1])*unit, (point[2] - origin[2])*unit } end
  if loop.shape then
    local s = loop.shape
    return { centre = moved(s.centre), radius = s.radius and s.radius*unit, angle = s.angle,
             radii = s.radii and { s.radii[1]*unit, s.radii[2]*unit } }
  end
  local points = {}
  for k, point in ipairs(loop.points) do points[k] = moved(point) end
  return { points = points }
end

local function unit_of(options, insunits)
  local unit = options.unit or units[insunits]
  if not unit then refuse(nil, "does not say its unit: give unit = mm, or another") end
  if type(unit) ~= "number" or not (unit > 0 and unit < math.huge) then
    refuse(nil, "cannot be read: unit must be above 0 m")
  end
  return unit
end

-- Returns it in units of the drawing.
local function tolerance_of(options, unit, found)
  local given = options.tolerance
  if given == nil then return math.max(1e-4*size_of(found), 1e-12) end
  if type(given) ~= "number" or not (given > 0 and given < math.huge) then
    refuse(nil, "cannot be read: tolerance must be above 0 m")
  end
  return given/unit
end

return function(options)
  if type(options) ~= "table" or type(options[1]) ~= "string" then
    error("dxf: give the name of a file, { \"a.dxf\" }", 2)
  end
  local found, insunits = entities.read(options[1])
  local unit = unit_of(options, insunits)
  found = readable(selected(found, options.layers))
  if #found == 0 then refuse(nil, "has no loop") end
  local tolerance = tolerance_of(options, unit, found)
  local loops, chains = {}, {}
  for _, e in ipairs(found) do
    local curve = readers[e.type](e, tolerance)
    curve.line = e.line
    table.insert((curve.shape or curve.closed) and loops or chains, curve)
  end
  for _, loop in ipairs(joined(chains, tolerance)) do loops[#loops + 1] = loop end
  if #loops == 0 then refuse(nil, "has no loop") end
  for _, loop in ipairs(loops) do measure(loop) end
  table.sort(loops, function(a, b) return a.area > b.area end)

  local outer, holes = loops[1], {}
  for k = 2, #loops do
    for axis = 1, 2 do
      if loops[k].low[axis] < outer.low[axis] - tolerance or loops[k].high[axis] > outer.high[axis] + tolerance then
        refuse(loops[k].line, "a loop lies outside of the largest one: read one part at a time, by its layer")
      end
    end
    holes[#holes + 1] = placed(loops[k], outer.low, unit)
  end
  return { outline = placed(outer, outer.low, unit), holes = holes }
end
