-- dxf/entities.lua: the groups of a DXF file as entities, for dxf.lua.
local entities = {}

local most_bytes = 16*1024*1024
local name -- of the file that is being read, for messages

-- Ends with an error that names the file and, if given, a line of it.
function entities.refuse(line, text)
  error(string.format("dxf: '%s'%s %s", name, line and ", line " .. line .. ":" or "", text), 0)
end

local function text_of(file)
  name = file
  local handle, why = io.open(file, "rb")
  if not handle then error("dxf: " .. why, 0) end
  local text = handle:read(most_bytes + 1)
  handle:close()
  if not text then entities.refuse(nil, "is empty, or a folder") end
  if #text > most_bytes then entities.refuse(nil, "is larger than 16 MiB") end
  if text:find("^AutoCAD Binary DXF") then entities.refuse(nil, "is a binary DXF: save it as ASCII") end
  return text
end

-- Returns a function that returns code, value and line of the next pair.
local function pairs_in(text)
  local next_line, number = text:gmatch("([^\n]*)\n?"), 0
  return function()
    number = number + 2
    local code, value = next_line(), next_line()
    if not code or code == "" and not value then return nil end
    code = math.tointeger(tonumber(code:match("^%s*(%-?%d+)%s*$") or ""))
    if not code or not value then entities.refuse(number - 1, "is no DXF: a group code must stand here") end
    return code, value:match("^%s*(.-)%s*$"), number
  end
end

local function finite(value, line)
  local found = tonumber(value)
  if not found or found ~= found or math.abs(found) >= 1e15 then
    entities.refuse(line, "a finite number must stand here")
  end
  return found
end

-- Returns the entities, each a type, a line, a layer, and lists of values by code; and the unit of the header.
local function entities_in(text)
  local all, entity, section, heading, unit = {}, nil, nil, false, nil
  local after_units = false
  for code, value, line in pairs_in(text) do
    if code == 0 then
      if value == "EOF" then return all, unit end
      heading = value == "SECTION"
      if value == "SECTION" or value == "ENDSEC" then section = nil end
      entity = section == "ENTITIES" and { type = value, line = line } or nil
      if entity then all[#all + 1] = entity end
    elseif heading and code == 2 then
      section, heading = value, false
    elseif section == "HEADER" then
      if after_units and code == 70 then unit = math.tointeger(tonumber(value) or 0) end
      after_units = code == 9 and value == "$INSUNITS"
    elseif entity and code == 8 then
      entity.layer = value
    elseif entity and (code >= 10 and code <= 79 or code == 210 or code == 230) then
      entity[code] = entity[code] or {}
      if code < 60 or code >= 70 then table.insert(entity[code], finite(value, line)) end
      if entity.type == "LWPOLYLINE" and code == 42 then
        entity.bulges = entity.bulges or {}
        entity.bulges[#(entity[10] or {})] = finite(value, line)
      end
    end
  end
  entities.refuse(nil, "is no DXF, or cut off: it does not end with EOF")
end

-- Returns the first value of a code; without a fallback it must be there.
function entities.first(entity, code, fallback)
  local value = entity[code] and entity[code][1] or fallback
  if not value then entities.refuse(entity.line, entity.type .. " has no group " .. code) end
  return value
end

-- Gathers the VERTEX entities of every POLYLINE into one entity like an LWPOLYLINE.
local function with_whole_polylines(found)
  local all, polyline = {}, nil
  for _, e in ipairs(found) do
    if e.type == "POLYLINE" then
      local flags = math.tointeger(entities.first(e, 70, 0)) or -1 -- 1: closed, 128: for line types
      if flags & ~129 ~= 0 then entities.refuse(e.line, "POLYLINE is a curve or a mesh: explode it") end
      polyline = { type = "LWPOLYLINE", line = e.line, layer = e.layer, bulges = {}, [10] = {}, [20] = {}, [70] = e[70] }
      all[#all + 1] = polyline
    elseif e.type == "VERTEX" then
      if not polyline then entities.refuse(e.line, "VERTEX without a POLYLINE") end
      table.insert(polyline[10], entities.first(e, 10))
      table.insert(polyline[20], entities.first(e, 20))
      polyline.bulges[#polyline[10]] = entities.first(e, 42, 0)
    elseif e.type ~= "SEQEND" then
      all[#all + 1] = e
    end
  end
  return all
end

-- Returns the entities of a file, and the unit of its header.
function entities.read(file)
  local found, unit = entities_in(text_of(file))
  return with_whole_polylines(found), unit
end

return entities
