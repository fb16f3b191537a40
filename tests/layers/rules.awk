# SPDX-License-Identifier: MIT
# Who may include whom. Reads "path:line:text" of every #include, prints "path:line: reason" for each breach.

function folder_of(path) {
  sub(/[^\/]*$/, "", path)
  return path
}

# The first `depth` folders of a path, "renderer/scene".
function head_of(path, depth,  parts, count, i, head) {
  count = split(path, parts, "/")
  for (i = 1; i <= depth && i < count; ++i) head = head (i > 1 ? "/" : "") parts[i]
  return head
}

# The room that a file of ours lies in.
function room_of(path) {
  if (path ~ /^plugins\/(sdk|host)\// || path ~ /^renderer\/(scene|gpu)\//) return head_of(path, 2)
  if (path ~ /^plugins\//) return "plugin"
  if (path ~ /^editor\/(ui\/|window\.)/) return "editor/ui"
  if (path ~ /^editor\/cli\//) return "editor/cli"
  return head_of(path, 1)
}

# Our own header that an include names, as a path from the root; "" for a library's.
function header_of(path, name) {
  if (name ~ /^steradian\//) return "plugins/sdk/" name
  if (name ~ /^(plugins|renderer|editor|shaders|tests)\//) return name
  if (quoted) return folder_of(path) name
  return ""
}

function breach(reason) {
  printf "%s:%s: %s (%s)\n", path, line, reason, included
}

# What each room may see of ours, besides itself.
function may_see(from, to) {
  if (from == to) return 1
  if (from == "plugin") return to == "plugins/sdk"
  if (from == "renderer/scene") return to == "plugins/sdk"
  if (from == "plugins/host") return to ~ /^(plugins\/sdk|renderer\/scene)$/ || header == "renderer/scene/image.hpp"
  if (from ~ /^renderer/) return to ~ /^(plugins\/sdk|renderer|renderer\/scene|renderer\/gpu|shaders)$/
  if (from == "editor/ui") return to ~ /^(plugins\/(sdk|host)|renderer|renderer\/scene|editor)$/
  if (from == "editor/cli") {
    if (to == "editor/ui") return path ~ /\/cli\/edit\./
    return to ~ /^(plugins\/(sdk|host)|renderer|renderer\/scene|editor)$/
  }
  if (from == "editor") return to ~ /^(plugins\/(sdk|host)|renderer|renderer\/scene|editor\/cli)$/
  return 0
}

{
  split($0, place, ":")
  path = place[1]
  line = place[2]
  if (!match($0, /#[ \t]*include[ \t]*[<"][^>"]+[>"]/)) next
  included = substr($0, RSTART, RLENGTH)
  quoted = included ~ /"/
  name = included
  gsub(/.*include[ \t]*[<"]|[>"]$/, "", name)
  from = room_of(path)
  if (from == "tests") next

  header = header_of(path, name)
  to = room_of(header)
  if (header != "") {
    if (!may_see(from, to)) breach(from " must not see " to)
    else if (from == "plugin" && to == "plugin" && folder_of(header) != folder_of(path))
      breach("a plugin must not see another plugin")
    next
  }
  if (name ~ /^vulkan\// && from != "renderer/gpu" && path != "editor/ui/imgui_vulkan.cpp")
    breach("Vulkan headers belong to renderer/gpu and editor/ui/imgui_vulkan.cpp")
  if (name ~ /^(imgui|GLFW\/|backends\/imgui)/ && from != "editor/ui")
    breach("ImGui and GLFW belong to editor/ui and editor/window")
  if (from ~ /^(plugins\/sdk|renderer\/scene)$/ && name !~ /^[a-z_0-9]+(\.h)?$/ && !(from == "renderer/scene" && name ~ /^glm\//))
    breach(from " needs the standard library" (from == "renderer/scene" ? " and GLM" : "") " only")
}
